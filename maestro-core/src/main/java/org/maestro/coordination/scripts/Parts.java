package org.maestro.coordination.scripts;

import java.util.function.Consumer;
import org.maestro.sl.Body;

/** The parts of a script by the forms of its body. */
final class Parts {
  private Parts() {}

  /** Not begun yet. */
  static Part of(Body body, Scope scope, Course course, String path, Consumer<Result> then) {
    if (body instanceof Body.Seq seq) {
      return new InTurn(seq.parts(), scope, course, path, then);
    } else if (body instanceof Body.Par par) {
      return new SideBySide(par.parts(), scope, course, path, then);
    } else if (body instanceof Body.If choice) {
      return new Choice(choice, scope, course, path, then);
    } else if (body instanceof Body.While loop) {
      return new Loop(loop, scope, course, path, then);
    } else if (body instanceof Body.ForEach each) {
      return new ForEach(each, scope, course, path, then);
    } else if (body instanceof Body.Let let) {
      return new Let(let, scope, course, path, then);
    } else if (body instanceof Body.Try attempt) {
      return new Attempt(attempt, scope, course, path, then);
    } else if (body instanceof Body.Hold hold) {
      return new Holding(hold, scope, course, path, then);
    } else if (body instanceof Body.Ask ask) {
      return new Asking(ask, scope, course, path, then);
    } else if (body instanceof Body.Run run) {
      return RunScript.asAStep(run, scope, course, path, then);
    } else if (body instanceof Body.Achieve
        || body instanceof Body.Look
        || body instanceof Body.Do) {
      return new Deed(body, scope, course, path, then);
    } else if (body instanceof Body.Say
        || body instanceof Body.Express
        || body instanceof Body.Tell) {
      return new Telling(body, scope, course, path, then);
    } else if (body instanceof Body.Await || body instanceof Body.Pause) {
      return new Waiting(body, scope, course, path, then);
    }
    return new Statement(body, scope, course, path, then);
  }
}
