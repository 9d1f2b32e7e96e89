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

/// Contiguous elements, like a vector's, that may also lie in memory owned elsewhere, such as a mapped file:
/// they are then read in place, and their owner stays alive. Reading is the same for both. Every non-const
/// access first copies external elements into a vector.
template <typename T>
class Storage {
    // Not is_trivially_copyable: Eigen's vectors aren't, although copying their bytes is fine.
    static_assert(std::is_standard_layout_v<T> && std::is_trivially_destructible_v<T>);

public:
    using value_type = T;
    using size_type = std::size_t;
    using const_iterator = const T*;
    using iterator = T*;

    Storage() = default;
    Storage(std::vector<T> elements) : own_(std::move(elements)) { view_own(); }
    Storage(std::initializer_list<T> elements) : own_(elements) { view_own(); }
    /// `elements` must stay valid and unchanged as long as `owner` lives.
    Storage(std::span<const T> elements, std::shared_ptr<const void> owner)
        : owner_(std::move(owner)), data_(elements.data()), size_(elements.size()) {}

    Storage(const Storage& other) : own_(other.own_), owner_(other.owner_) { view_like(other); }
    Storage(Storage&& other) noexcept : own_(std::move(other.own_)), owner_(std::move(other.owner_)) {
        view_like(other);
        other.clear();
    }
    Storage& operator=(Storage other) noexcept {
        own_.swap(other.own_);
        owner_.swap(other.owner_);
        view_like(other);
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
    /// Elements that fit without allocating.
    std::size_t capacity() const { return is_external() ? size_ : own_.capacity(); }
    /// Whether the elements lie in memory owned elsewhere.
    bool is_external() const { return owner_ != nullptr; }

    T* data() { return own().data(); }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    T& operator[](std::size_t i) { return data()[i]; }
    T& front() { return data()[0]; }
    T& back() { return data()[size_ - 1]; }

    void reserve(std::size_t count) {
        own().reserve(count);
        view_own();
    }
    void resize(std::size_t count) {
        own().resize(count);
        view_own();
    }
    void resize(std::size_t count, const T& element) {
        own().resize(count, element);
        view_own();
    }
    void clear() {
        own_.clear();
        owner_.reset();
        view_own();
    }
    void push_back(const T& element) {
        own().push_back(element);
        view_own();
    }
    template <typename... Arguments>
    T& emplace_back(Arguments&&... arguments) {
        own().emplace_back(std::forward<Arguments>(arguments)...);
        view_own();
        return own_.back();
    }
    void pop_back() {
        own().pop_back();
        view_own();
    }
    void assign(std::size_t count, const T& element) { *this = Storage(std::vector<T>(count, element)); }
    /// The range must not be part of this storage.
    template <typename Iterator>
    void insert(const T* before, Iterator first, Iterator last) {
        const auto at = before - data_;
        std::vector<T>& elements = own();
        elements.insert(elements.begin() + at, first, last);
        view_own();
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
    void view_own() {
        data_ = own_.data();
        size_ = own_.size();
    }
    void view_like(const Storage& other) {
        if (owner_ == nullptr) {
            view_own();
        } else {
            data_ = other.data_;
            size_ = other.size_;
        }
    }

    std::vector<T> own_;                 ///< empty while the elements are external
    std::shared_ptr<const void> owner_;  ///< null while the elements are in `own_`
    const T* data_ = nullptr;            ///< of the elements, wherever they are
    std::size_t size_ = 0;
};

}  // namespace campuswalk::collision
