package org.maestro.coordination.scripts;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.ontology.home.Script;
import org.maestro.sl.Body;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Another script, as a part of this one. */
final class RunScript extends Part {
  private final Body.Run run;
  private final Scope scope;
  private final boolean isForItsValue;
  private Optional<Part> body = Optional.empty();

  RunScript(Body.Run run, Scope scope, Course course, String path, Consumer<Result> then) {
    this(run, scope, course, path, then, true);
  }

  private RunScript(
      Body.Run run,
      Scope scope,
      Course course,
      String path,
      Consumer<Result> then,
      boolean isForItsValue) {
    super(course, path, then);
    this.run = run;
    this.scope = scope;
    this.isForItsValue = isForItsValue;
  }

  /** What it gives is of no use, and does not end the script that runs it. */
  static RunScript asAStep(
      Body.Run run, Scope scope, Course course, String path, Consumer<Result> then) {
    return new RunScript(run, scope, course, path, then, false);
  }

  @Override
  void proceed() {
    Optional<Script> script = course.script(run.script());
    List<Term> arguments = scope.apply(run.arguments());
    if (script.isEmpty()) {
      finish(new Result.Failed("There is no script %s in this home.".formatted(run.script())));
    } else if (script.get().parameters().size() != arguments.size()) {
      finish(
          new Result.Failed(
              "The script %s takes %d values, not %d."
                  .formatted(run.script(), script.get().parameters().size(), arguments.size())));
    } else if (scope.depth() >= Course.DEEPEST) {
      finish(
          new Result.Failed(
              "Scripts run each other more than %d deep; %s is not run."
                  .formatted(Course.DEEPEST, run.script())));
    } else {
      course.told().runs(path, SlPrinter.print(new Formula.Atom(run.script(), arguments)));
      course.steps().within(path, 1, script.get().body());
      Part part =
          course.part(
              script.get().body(),
              Course.scope(script.get(), arguments, scope.depth() + 1),
              below(1),
              this::ran);
      body = Optional.of(part);
      part.begin();
    }
  }

  private void ran(Result result) {
    finish(result instanceof Result.Returned && !isForItsValue ? new Result.Done() : result);
  }

  @Override
  void stop(Runnable then) {
    body.ifPresentOrElse(part -> part.callOff(then), then);
  }
}
