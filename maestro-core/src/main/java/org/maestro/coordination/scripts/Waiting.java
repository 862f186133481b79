package org.maestro.coordination.scripts;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.maestro.sl.Body;
import org.maestro.sl.SlPrinter;

/** A part that lasts until a condition is known to hold, or for some time. */
final class Waiting extends Part {
  private final Body body;
  private final Scope scope;
  private Optional<Runnable> ends = Optional.empty();

  Waiting(Body body, Scope scope, Course course, String path, Consumer<Result> then) {
    super(course, path, then);
    this.body = body;
    this.scope = scope;
  }

  @Override
  void proceed() {
    if (body instanceof Body.Await await) {
      if (course.isKnown(await.condition(), scope)) {
        finish(new Result.Done());
      } else {
        course.told().waits(path, SlPrinter.print(scope.apply(await.condition())));
        ends =
            Optional.of(
                course.watch(
                    await.condition(),
                    scope,
                    () -> {
                      if (course.isKnown(await.condition(), scope)) {
                        over();
                      }
                    }));
      }
      return;
    }
    OptionalDouble seconds = course.number(((Body.Pause) body).seconds(), scope);
    if (seconds.isEmpty() || seconds.getAsDouble() < 0) {
      finish(new Result.Failed("How long is to be waited is not known."));
    } else {
      Duration time = Duration.ofMillis(Math.round(seconds.getAsDouble() * 1000));
      ends = Optional.of(course.after(left(time), this::over));
    }
  }

  /** Less than all of it where it was begun before a restart. */
  private Duration left(Duration time) {
    Optional<Duration> before = course.notes().until(path);
    if (before.isEmpty()) {
      course.notes().until(path, course.now().plus(time));
      return time;
    }
    Duration left = before.get().minus(course.now());
    return left.compareTo(time) < 0 ? left : time;
  }

  private void over() {
    ends.ifPresent(Runnable::run);
    ends = Optional.empty();
    finish(new Result.Done());
  }

  @Override
  void stop(Runnable then) {
    ends.ifPresent(Runnable::run);
    ends = Optional.empty();
    then.run();
  }
}
