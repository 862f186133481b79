package org.maestro.coordination.scripts;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.sl.Body;

/** Parts one after the other. */
final class InTurn extends Part {
  private final List<Body> bodies;
  private final Scope scope;
  private Optional<Part> current = Optional.empty();

  InTurn(List<Body> bodies, Scope scope, Course course, String path, Consumer<Result> then) {
    super(course, path, then);
    this.bodies = bodies;
    this.scope = scope;
  }

  @Override
  void proceed() {
    next(0);
  }

  private void next(int at) {
    if (at == bodies.size()) {
      finish(new Result.Done());
      return;
    }
    Part part =
        course.part(
            bodies.get(at),
            scope,
            below(at + 1),
            result -> {
              if (result instanceof Result.Done) {
                next(at + 1);
              } else {
                finish(result);
              }
            });
    current = Optional.of(part);
    part.begin();
  }

  @Override
  void stop(Runnable then) {
    current.ifPresentOrElse(part -> part.callOff(then), then);
  }
}
