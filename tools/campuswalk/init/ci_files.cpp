#include "tools/campuswalk/init/ci_files.h"

#include <string_view>
#include <utility>

namespace campuswalk::tools::init {

namespace {

constexpr std::string_view kRepository = CAMPUSWALK_REPOSITORY;  // OWNER/NAME; empty if this build knows none

constexpr const char* kWorkflow = R"(name: walks
on: [push, pull_request]
permissions:
  contents: read
jobs:
  walks:
    runs-on: ubuntu-24.04
    steps:
      - uses: actions/checkout@11bd71901bbe5b1630ceea73d27597364c9af683 # v4.2.2
        with:
          persist-credentials: false
)";

constexpr const char* kPublishedAction = R"(      - uses: @REPOSITORY@@@REVISION@ # v@VERSION@
        with:
)";

constexpr const char* kActionOfAVariable =
    R"(      # The repository variable CAMPUSWALK, as OWNER/NAME, says where campuswalk and its releases are.
      - name: Check where campuswalk comes from
        if: ${{ vars.CAMPUSWALK == '' }}
        run: |
          echo "::error::set the repository variable CAMPUSWALK to OWNER/NAME of campuswalk's repository"
          exit 1
      - uses: actions/checkout@11bd71901bbe5b1630ceea73d27597364c9af683 # v4.2.2
        with:
          repository: ${{ vars.CAMPUSWALK }}
          ref: @REVISION@
          path: .campuswalk
          persist-credentials: false
      - uses: ./.campuswalk
        with:
          repository: ${{ vars.CAMPUSWALK }}
)";

constexpr const char* kActionSettings = R"(          version: @VERSION@
          arguments: |
            --strict
            --forbid-only
)";

constexpr const char* kPipeline = R"(# Failed walks are listed in the merge request, with their pictures.
walks:
  image: debian:12
  variables:
@ADDRESS@    CAMPUSWALK_SHA256: ""   # from the release's SHA256SUMS: refuses any other package
    CAMPUSWALK_CACHE_DIR: /var/cache/campuswalk
  before_script:
    - test -n "$CAMPUSWALK" || { echo "set the CI/CD variable CAMPUSWALK to the address of campuswalk's .deb"; exit 1; }
    - apt-get update -q
    - apt-get install -y -q --no-install-recommends ca-certificates curl
    - curl --fail --silent --show-error --location --proto =https --output /tmp/campuswalk.deb "$CAMPUSWALK"
    - test -z "$CAMPUSWALK_SHA256" || echo "$CAMPUSWALK_SHA256  /tmp/campuswalk.deb" | sha256sum --check
    - apt-get install -y -q /tmp/campuswalk.deb
    # GitLab keeps only what is in the project, and campuswalk trusts no cache that could have come with it.
    - mkdir -p .campuswalk "$CAMPUSWALK_CACHE_DIR" && cp -R .campuswalk/. "$CAMPUSWALK_CACHE_DIR"
  script:
    - >-
      campuswalk run --strict --forbid-only --reporter list
      --reporter junit=out/junit.xml --reporter html=out/report.html
  after_script:
    - cp -R /var/cache/campuswalk/. .campuswalk
  cache:
    key: campuswalk
    paths: [.campuswalk]
  artifacts:
    when: always
    paths: [out]
    reports:
      junit: out/junit.xml
)";

std::string filled(std::string text, std::string_view name, std::string_view value) {
    const std::string mark = "@" + std::string(name) + "@";
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size())) {
        text.replace(at, mark.size(), value);
    }
    return text;
}

std::string filled(const std::string& text) {
    return filled(filled(filled(text, "REPOSITORY", kRepository), "REVISION", CAMPUSWALK_REVISION), "VERSION",
                  CAMPUSWALK_VERSION);
}

std::string workflow() {
    const char* action = kRepository.empty() ? kActionOfAVariable : kPublishedAction;
    return filled(std::string(kWorkflow) + action + kActionSettings);
}

std::string pipeline() {
    const std::string address = kRepository.empty() ? ""
                                                    : filled(
                                                          "    CAMPUSWALK: "
                                                          "https://github.com/@REPOSITORY@/releases/download/"
                                                          "v@VERSION@/campuswalk_@VERSION@_amd64.deb\n");
    return filled(kPipeline, "ADDRESS", address);
}

}  // namespace

std::optional<NewFile> ci_file(Service service) {
    switch (service) {
        case Service::github:
            return NewFile{".github/workflows/walks.yml", workflow()};
        case Service::gitlab:
            return NewFile{".gitlab-ci.yml", pipeline()};
        case Service::none:
            break;
    }
    return std::nullopt;
}

}  // namespace campuswalk::tools::init
