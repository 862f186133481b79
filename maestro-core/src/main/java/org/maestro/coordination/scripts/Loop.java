package org.maestro.coordination.scripts;

import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.sl.Body;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * A part again and again, as long as a condition is known to hold. Where a round has begun nothing
 * that takes time, the next one waits for news of the condition.
 */
final class Loop extends Part {
  private final Body.While loop;
  private final Scope scope;
  private Optional<Part> round = Optional.empty();
  private Optional<Runnable> watching = Optional.empty();
  private Optional<FactFilter> reading = Optional.empty();

  Loop(Body.While loop, Scope scope, Course course, String path, Consumer<Result> then) {
    super(course, path, then);
    this.loop = loop;
    this.scope = scope;
  }

  @Override
  void proceed() {
    next(
        course.notes().value(path).filter(Term.Number.class::isInstance).stream()
            .mapToInt(term -> (int) ((Term.Number) term).value())
            .findFirst()
            .orElse(0));
  }

  private void next(int finished) {
    if (isOver()) {
      return;
    }
    String begun = below(finished + 1);
    closeReading();
    reading = Optional.of(course.reading());
    boolean wasBegun = course.notes().isBegun(begun);
    boolean goesOn = course.isKnown(loop.condition(), scope) || wasBegun;
    if (!goesOn) {
      end(new Result.Done());
    } else if (loop.most().isPresent() && finished >= loop.most().getAsInt()) {
      end(
          new Result.Failed(
              "After %d rounds it is still so that %s."
                  .formatted(finished, SlPrinter.print(scope.apply(loop.condition())))));
    } else {
      course.steps().within(path, finished + 1, loop.body());
      // What was done before a restart took time then.
      long deeds = wasBegun ? -1 : course.deeds();
      Consumer<Result> then = result -> ended(finished + 1, deeds, result);
      if (loop.body() instanceof Body.Hold hold && hold.parts().isEmpty()) {
        hold(new Holding(hold, scope, course, begun, then));
      } else {
        begin(course.part(loop.body(), scope, begun, then));
      }
    }
  }

  private void begin(Part part) {
    round = Optional.of(part);
    part.begin();
  }

  /** The round is over when the condition is not known to hold any more. */
  private void hold(Holding holding) {
    Runnable look =
        () -> {
          if (!course.isKnown(loop.condition(), scope)) {
            stopWatching();
            holding.letGo();
          }
        };
    watching = Optional.of(course.watch(reading.orElseThrow(), () -> course.whenReady(look)));
    begin(holding);
    course.whenReady(look);
  }

  private void ended(int finished, long deedsBefore, Result result) {
    round = Optional.empty();
    stopWatching();
    if (!(result instanceof Result.Done)) {
      end(result);
      return;
    }
    course.notes().value(path, new Term.Number(finished));
    if (course.deeds() > deedsBefore) {
      course.later(() -> next(finished));
    } else {
      watching =
          Optional.of(
              course.watch(
                  reading.orElseThrow(),
                  () -> {
                    stopWatching();
                    next(finished);
                  }));
    }
  }

  private void end(Result result) {
    closeReading();
    finish(result);
  }

  private void closeReading() {
    reading.ifPresent(course::closeReading);
    reading = Optional.empty();
  }

  private void stopWatching() {
    watching.ifPresent(Runnable::run);
    watching = Optional.empty();
  }

  @Override
  void stop(Runnable then) {
    stopWatching();
    closeReading();
    round.ifPresentOrElse(part -> part.callOff(then), then);
  }
}
