#include "tools/campuswalk/init/ci_files.h"

#include <initializer_list>
#include <string_view>
#include <utility>

namespace campuswalk::tools::init {

namespace {

constexpr const char* kOpening = R"(name: walks
on: [push, pull_request]
permissions:
  contents: read
)";

constexpr const char* kUnknownPlace = R"(env:
  # To be filled in here: pull requests from forks don't get the repository's variables.
  CAMPUSWALK: ""   # OWNER/NAME of the repository with campuswalk's releases
  CAMPUSWALK_COMMIT: "@COMMIT@"   # of release @VERSION@ there, 40 digits: a tag can be moved
)";

constexpr const char* kJob = R"(jobs:
  walks:
    runs-on: ubuntu-24.04
    timeout-minutes: 30
    steps:
      - uses: actions/checkout@11bd71901bbe5b1630ceea73d27597364c9af683 # v4.2.2
        with:
          persist-credentials: false
)";

constexpr const char* kPublishedAction = R"(      - uses: @REPOSITORY@@@COMMIT@ # v@VERSION@
        with:
)";

constexpr const char* kActionOfThatPlace = R"(      - name: Check where campuswalk comes from
        run: |
          [[ $CAMPUSWALK == ?*/?* && $CAMPUSWALK_COMMIT =~ ^[0-9a-f]{40}$ ]] || {
            echo "::error::fill in CAMPUSWALK and CAMPUSWALK_COMMIT in this workflow"
            exit 1
          }
          if [[ -e .campuswalk || -L .campuswalk ]]; then
            echo "::error::.campuswalk is where the action goes: the commit may not have it"
            exit 1
          fi
      - uses: actions/checkout@11bd71901bbe5b1630ceea73d27597364c9af683 # v4.2.2
        with:
          repository: ${{ env.CAMPUSWALK }}
          ref: ${{ env.CAMPUSWALK_COMMIT }}
          path: .campuswalk
          persist-credentials: false
      - uses: ./.campuswalk
        with:
          repository: ${{ env.CAMPUSWALK }}
)";

constexpr const char* kActionSettings = R"(          version: @VERSION@
          sha256: ""   # from the release's SHA256SUMS, of its linux-x86_64.tar.xz
          arguments: |
            --strict
            --forbid-only
            --min-cases=@WALKS@
)";

constexpr const char* kPipeline =
    R"(# Failed walks are listed in the merge request, with their pictures. They are in a folder with the commit's hash in its
# name: nobody can commit files or links there that would be taken for what the job has written.
walks:
  image: debian:12
  timeout: 30 minutes
  variables:
    # To be filled in here: pipelines of forks don't get the project's variables.
    CAMPUSWALK: "@ADDRESS@"   # campuswalk_@VERSION@_amd64.deb: its https address, or a path in the project
    CAMPUSWALK_SHA256: ""   # of that file, from the release's SHA256SUMS
  before_script:
    - >-
      test -n "$CAMPUSWALK" && test -n "$CAMPUSWALK_SHA256" ||
      { echo "fill in CAMPUSWALK and CAMPUSWALK_SHA256 in .gitlab-ci.yml"; exit 1; }
    - apt-get update -q
    - apt-get install -y -q --no-install-recommends ca-certificates curl
    - |
      case "$CAMPUSWALK" in
        https://*) curl --fail --silent --show-error --location --proto =https \
                     --output /tmp/campuswalk.deb "$CAMPUSWALK" ;;
        *) cp "$CAMPUSWALK" /tmp/campuswalk.deb ;;
      esac
    - echo "$CAMPUSWALK_SHA256  /tmp/campuswalk.deb" | sha256sum --check
    - apt-get install -y -q /tmp/campuswalk.deb
  script:
    # No cache is kept between jobs: the pipeline of any branch could write to it.
    - >-
      campuswalk run --strict --forbid-only --min-cases=@WALKS@ --sandbox require
      --output "campuswalk-$CI_COMMIT_SHA" --reporter list
      --reporter "junit=campuswalk-$CI_COMMIT_SHA/junit.xml"
      --reporter "html=campuswalk-$CI_COMMIT_SHA/report.html"
  artifacts:
    when: always
    paths: ["campuswalk-$CI_COMMIT_SHA"]
    reports:
      junit: "campuswalk-$CI_COMMIT_SHA/junit.xml"
)";

using Value = std::pair<std::string_view, std::string>;

std::string filled(std::string text, std::initializer_list<Value> values) {
    for (const auto& [name, value] : values) {
        const std::string mark = "@" + std::string(name) + "@";
        for (std::size_t at = text.find(mark); at != std::string::npos;
             at = text.find(mark, at + value.size())) {
            text.replace(at, mark.size(), value);
        }
    }
    return text;
}

std::string workflow(const Publication& from, std::size_t walks) {
    const bool is_known = !from.repository.empty() && !from.commit.empty();
    const std::string text = std::string(kOpening) + (is_known ? "" : kUnknownPlace) + kJob +
                             (is_known ? kPublishedAction : kActionOfThatPlace) + kActionSettings;
    return filled(text, {{"REPOSITORY", from.repository},
                         {"COMMIT", from.commit},
                         {"VERSION", from.version},
                         {"WALKS", std::to_string(walks)}});
}

std::string pipeline(const Publication& from, std::size_t walks) {
    const std::string address = from.repository.empty()
                                    ? ""
                                    : "https://github.com/" + from.repository + "/releases/download/v" +
                                          from.version + "/campuswalk_" + from.version + "_amd64.deb";
    return filled(kPipeline,
                  {{"ADDRESS", address}, {"VERSION", from.version}, {"WALKS", std::to_string(walks)}});
}

}  // namespace

Publication publication() {
    return {.repository = CAMPUSWALK_REPOSITORY, .commit = CAMPUSWALK_COMMIT, .version = CAMPUSWALK_VERSION};
}

std::optional<NewFile> ci_file(Service service, const Publication& from, std::size_t walks) {
    switch (service) {
        case Service::github:
            return NewFile{".github/workflows/walks.yml", workflow(from, walks)};
        case Service::gitlab:
            return NewFile{".gitlab-ci.yml", pipeline(from, walks)};
        case Service::none:
            break;
    }
    return std::nullopt;
}

}  // namespace campuswalk::tools::init
