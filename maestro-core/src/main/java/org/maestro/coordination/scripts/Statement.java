package org.maestro.coordination.scripts;

import java.util.function.Consumer;
import org.maestro.sl.Body;

/** A part that takes no time: a statement, a result, a failure. */
final class Statement extends Part {
  private final Body body;
  private final Scope scope;

  Statement(Body body, Scope scope, Course course, String path, Consumer<Result> then) {
    super(course, path, then);
    this.body = body;
    this.scope = scope;
  }

  @Override
  void proceed() {
    if (body instanceof Body.Assert stated) {
      course.state(scope.apply(stated.effect()), path);
      finish(new Result.Done());
    } else if (body instanceof Body.Return back) {
      finish(new Result.Returned(scope.apply(back.value())));
    } else {
      finish(new Result.Failed(((Body.Fail) body).reason()));
    }
  }

  @Override
  void stop(Runnable then) {
    then.run();
  }
}
