// Counts the work that a motion and its questions are: no second road may be more.
#pragma once

#include "poinsot/engine/work/work.h"
#include "problem/course/course.h"

namespace poinsot::problem {

// Counts from here to the end of the block, once where such blocks stand in each other.
class Course::WorkCounted {
 public:
  explicit WorkCounted(Course& motion) : motion_(motion), outermost_(!motion.counting_), begin_(work_done()) {
    motion_.counting_ = true;
  }
  ~WorkCounted() {
    if (!outermost_) return;
    motion_.counting_ = false;
    motion_.work_ += work_done() - begin_;
  }
  WorkCounted(const WorkCounted&) = delete;
  WorkCounted& operator=(const WorkCounted&) = delete;

 private:
  Course& motion_;
  const bool outermost_;
  const Work begin_;
};

}  // namespace poinsot::problem
