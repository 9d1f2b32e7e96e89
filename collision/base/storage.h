#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace campuswalk::collision {

/// Elements in a row, as a vector has them, that may also lie in memory of somebody else's, such as a file
/// that is mapped: then they are looked at where they are, and what owns the memory is kept alive. Reading is
/// the same for both. Whatever could change elements that lie elsewhere makes a vector of them first.
template <typename T>
class Storage {
    // Eigen's vectors are but their bytes, too, although they don't say so.
    static_assert(std::is_standard_layout_v<T> && std::is_trivially_destructible_v<T>);

public:
    using value_type = T;
    using size_type = std::size_t;
    using const_iterator = const T*;
    using iterator = T*;

    Storage() = default;
    Storage(std::vector<T> elements) : own_(std::move(elements)) { look(); }
    Storage(std::initializer_list<T> elements) : own_(elements) { look(); }
    /// `elements` stay what they are as long as `owner` lives.
    Storage(std::span<const T> elements, std::shared_ptr<const void> owner)
        : owner_(std::move(owner)), data_(elements.data()), size_(elements.size()) {}

    Storage(const Storage& other) : own_(other.own_), owner_(other.owner_) { look_as(other); }
    Storage(Storage&& other) noexcept : own_(std::move(other.own_)), owner_(std::move(other.owner_)) {
        look_as(other);
        other.clear();
    }
    Storage& operator=(Storage other) noexcept {
        own_.swap(other.own_);
        owner_.swap(other.owner_);
        look_as(other);
        return *this;
    }
    ~Storage() = default;

    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }
    const T* data() const { return data_; }
    const T* begin() const { return data_; }
    const T* end() const { return data_ + size_; }
    const T& operator[](std::size_t i) const { return data_[i]; }
    const T& front() const { return data_[0]; }
    const T& back() const { return data_[size_ - 1]; }
    /// How many there is room for without taking more memory.
    std::size_t capacity() const { return is_elsewhere() ? size_ : own_.capacity(); }
    /// Whether the elements lie in memory of somebody else's.
    bool is_elsewhere() const { return owner_ != nullptr; }

    T* data() { return own().data(); }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    T& operator[](std::size_t i) { return data()[i]; }
    T& front() { return data()[0]; }
    T& back() { return data()[size_ - 1]; }

    void reserve(std::size_t count) {
        own().reserve(count);
        look();
    }
    void resize(std::size_t count) {
        own().resize(count);
        look();
    }
    void resize(std::size_t count, const T& element) {
        own().resize(count, element);
        look();
    }
    void clear() {
        own_.clear();
        owner_.reset();
        look();
    }
    void push_back(const T& element) {
        own().push_back(element);
        look();
    }
    template <typename... Arguments>
    T& emplace_back(Arguments&&... arguments) {
        own().emplace_back(std::forward<Arguments>(arguments)...);
        look();
        return own_.back();
    }
    void pop_back() {
        own().pop_back();
        look();
    }
    void assign(std::size_t count, const T& element) { *this = Storage(std::vector<T>(count, element)); }
    /// `first` and `last` aren't of this storage itself.
    template <typename Iterator>
    void insert(const T* before, Iterator first, Iterator last) {
        const auto at = before - data_;
        std::vector<T>& elements = own();
        elements.insert(elements.begin() + at, first, last);
        look();
    }

    void insert(const T* before, std::initializer_list<T> elements) {
        insert(before, elements.begin(), elements.end());
    }

    friend bool operator==(const Storage& a, const Storage& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    }

private:
    std::vector<T>& own() {
        if (owner_ != nullptr) {
            *this = Storage(std::vector<T>(data_, data_ + size_));
        }
        return own_;
    }
    void look() {
        data_ = own_.data();
        size_ = own_.size();
    }
    void look_as(const Storage& other) {
        if (owner_ == nullptr) {
            look();
        } else {
            data_ = other.data_;
            size_ = other.size_;
        }
    }

    std::vector<T> own_;                 ///< empty while they are elsewhere
    std::shared_ptr<const void> owner_;  ///< null while they are here
    const T* data_ = nullptr;            ///< of the elements, wherever they are
    std::size_t size_ = 0;
};

}  // namespace campuswalk::collision
