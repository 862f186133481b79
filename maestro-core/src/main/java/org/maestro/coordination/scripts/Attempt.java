package org.maestro.coordination.scripts;

import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.sl.Body;

/** A part that is recovered from when it fails, and after which something is done in any case. */
final class Attempt extends Part {
  static final int TRIED = 1;
  static final int LAST = 2;
  static final int RECOVERIES = 3;

  private final Body.Try attempt;
  private final Scope scope;
  private Optional<Part> current = Optional.empty();
  private boolean isAtLast;
  private Optional<Runnable> afterLast = Optional.empty();

  Attempt(Body.Try attempt, Scope scope, Course course, String path, Consumer<Result> then) {
    super(course, path, then);
    this.attempt = attempt;
    this.scope = scope;
  }

  @Override
  void proceed() {
    begin(attempt.body(), TRIED, this::tried);
  }

  private void begin(Body body, int number, Consumer<Result> then) {
    Part part = course.part(body, scope, below(number), then);
    current = Optional.of(part);
    part.begin();
  }

  private void tried(Result result) {
    if (result instanceof Result.Failed failed) {
      for (int i = 0; i < attempt.recoveries().size(); i++) {
        Body.Recovery recovery = attempt.recoveries().get(i);
        if (recovery.reason().filter(reason -> !failed.reason().contains(reason)).isEmpty()) {
          course.told().recovers(path, failed.reason());
          begin(recovery.body(), RECOVERIES + i, this::last);
          return;
        }
      }
    }
    last(result);
  }

  private void last(Result result) {
    if (attempt.last().isEmpty()) {
      finish(result);
    } else {
      isAtLast = true;
      begin(
          attempt.last().get(),
          LAST,
          ended -> {
            if (afterLast.isPresent()) {
              afterLast.get().run();
            } else {
              finish(ended instanceof Result.Failed ? ended : result);
            }
          });
    }
  }

  /** What is to be done in any case is done now, whether it succeeds or not. */
  @Override
  void stop(Runnable then) {
    if (isAtLast) {
      afterLast = Optional.of(then);
      return;
    }
    Runnable last =
        () -> attempt.last().ifPresentOrElse(body -> begin(body, LAST, result -> then.run()), then);
    current.ifPresentOrElse(part -> part.callOff(last), last);
  }
}
