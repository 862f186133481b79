package org.maestro.coordination.scripts;

import java.util.Optional;
import java.util.function.Consumer;

/**
 * A part of a script that is carried out. It begins once, and ends once: with a result, of which it
 * tells, or because it is called off, of which it does not. The coordinator's thread only.
 */
abstract class Part {
  final Course course;
  final String path;
  private final Consumer<Result> then;
  private boolean over;
  private boolean calledOff;

  /**
   * @param then told the result
   */
  Part(Course course, String path, Consumer<Result> then) {
    this.course = course;
    this.path = path;
    this.then = then;
  }

  /** What was done before a restart is not done again. */
  final void begin() {
    Optional<Result> before = course.notes().result(path);
    if (before.isPresent()) {
      over = true;
      course.steps().wasOver(path, before.get());
      then.accept(before.get());
    } else {
      course.whenReady(
          () -> {
            if (!calledOff) {
              course.steps().begun(path);
              proceed();
            }
          });
    }
  }

  /** Does what is to be done, and at the end {@link #finish}. */
  abstract void proceed();

  /** Writes the result down, and tells it. */
  final void finish(Result result) {
    if (!isOver() && !path.isEmpty()) {
      course.notes().over(path, result);
    }
    finishUnwritten(result);
  }

  /** The same, where it is written down elsewhere. */
  final void finishUnwritten(Result result) {
    if (!isOver()) {
      over = true;
      course.steps().ended(path, result);
      then.accept(result);
    }
  }

  /**
   * Calls off what is under way, and does what is to be done in any case.
   *
   * @param then run once nothing is under way any more
   */
  final void callOff(Runnable then) {
    if (calledOff || over) {
      then.run();
    } else {
      calledOff = true;
      course.steps().calledOff(path);
      stop(then);
    }
  }

  final boolean isOver() {
    return over || calledOff;
  }

  abstract void stop(Runnable then);

  /** The path of what is below it, counted from 1. */
  final String below(int number) {
    return Place.below(path, number);
  }
}
