// SPDX-License-Identifier: MIT
#pragma once

// Before a function whose loops the compiler vectorises: one build runs on every processor and uses
// wide registers where they exist. Neither variant fuses multiplication and addition, so that both
// give the same bits. The variant is chosen before the thread sanitizer is there, which ends that.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define REVISIT_SLAM_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define REVISIT_SLAM_VECTOR_CLONES
#endif
