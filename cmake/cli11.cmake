# Headers that read command lines. Ubuntu 20.04 and Debian 11 have no package of them: there the version of
# Debian 12 is fetched.
find_package(CLI11 QUIET)
if(NOT TARGET CLI11::CLI11)
  include(FetchContent)
  FetchContent_Declare(cli11 GIT_REPOSITORY https://github.com/CLIUtils/CLI11.git
                       GIT_TAG 70f8072f9dd2292fd0b9f9e5f58e279f60483ed3)  # 2.1.2
  FetchContent_GetProperties(cli11)
  if(NOT cli11_POPULATED)
    message(STATUS "No package CLI11 was found: fetching its headers")
    FetchContent_Populate(cli11)
  endif()
  add_library(CLI11::CLI11 INTERFACE IMPORTED)
  target_include_directories(CLI11::CLI11 SYSTEM INTERFACE ${cli11_SOURCE_DIR}/include)
endif()
