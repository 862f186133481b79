package org.maestro.coordination.scripts;

import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.sl.Body;
import org.maestro.sl.Term;

/** One of two ways: the way that is taken is noted, whatever becomes of the condition. */
final class Choice extends Part {
  static final int THEN = 1;
  static final int OTHERWISE = 2;

  private final Body.If choice;
  private final Scope scope;
  private Optional<Part> taken = Optional.empty();

  Choice(Body.If choice, Scope scope, Course course, String path, Consumer<Result> then) {
    super(course, path, then);
    this.choice = choice;
    this.scope = scope;
  }

  @Override
  void proceed() {
    boolean isSo =
        course
            .notes()
            .value(path)
            .map(noted -> noted.equals(new Term.Truth(true)))
            .orElseGet(() -> course.isKnown(choice.condition(), scope));
    course.notes().value(path, new Term.Truth(isSo));
    if (!isSo && choice.otherwise().isEmpty()) {
      finish(new Result.Done());
      return;
    }
    Body way = isSo ? choice.then() : choice.otherwise().orElseThrow();
    Part part = course.part(way, scope, below(isSo ? THEN : OTHERWISE), this::finish);
    taken = Optional.of(part);
    part.begin();
  }

  @Override
  void stop(Runnable then) {
    taken.ifPresentOrElse(part -> part.callOff(then), then);
  }
}
