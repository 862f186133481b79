package org.maestro.coordination.scripts;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.sl.Body;

/** Parts side by side: over when all are; when one fails, or returns, the others are called off. */
final class SideBySide extends Part {
  private final List<Body> bodies;
  private final Scope scope;
  private final List<Part> parts = new ArrayList<>();
  private Optional<Result> decided = Optional.empty();
  private int left;

  SideBySide(List<Body> bodies, Scope scope, Course course, String path, Consumer<Result> then) {
    super(course, path, then);
    this.bodies = bodies;
    this.scope = scope;
    this.left = bodies.size();
  }

  @Override
  void proceed() {
    for (int i = 0; i < bodies.size(); i++) {
      parts.add(course.part(bodies.get(i), scope, below(i + 1), this::ended));
    }
    List.copyOf(parts)
        .forEach(
            part -> {
              if (decided.isEmpty()) {
                part.begin();
              }
            });
  }

  private void ended(Result result) {
    if (decided.isPresent()) {
      return;
    }
    left--;
    if (!(result instanceof Result.Done)) {
      decided = Optional.of(result);
      callOffAll(() -> finish(result));
    } else if (left == 0) {
      finish(result);
    }
  }

  private void callOffAll(Runnable then) {
    int[] running = {parts.size()};
    for (Part part : parts) {
      part.callOff(
          () -> {
            running[0]--;
            if (running[0] == 0) {
              then.run();
            }
          });
    }
  }

  @Override
  void stop(Runnable then) {
    if (parts.isEmpty()) {
      then.run();
    } else {
      callOffAll(then);
    }
  }
}
