package org.maestro.coordination.scripts;

import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.sl.Body;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * A part that tells somebody something: over when that is there, failed when nobody takes it. After
 * a restart in between it is told once more, as the same part.
 */
final class Telling extends Part {
  private final Body body;
  private final Scope scope;

  Telling(Body body, Scope scope, Course course, String path, Consumer<Result> then) {
    super(course, path, then);
    this.body = body;
    this.scope = scope;
  }

  @Override
  void proceed() {
    if (body instanceof Body.Say say) {
      Term who = scope.apply(say.who());
      if (who instanceof Term.Name name) {
        course.say(path, name.text(), scope.apply(say.words()), this::told);
      } else {
        finish(new Result.Failed("%s hears nothing.".formatted(SlPrinter.print(who))));
      }
      return;
    }
    Body.Tell tell = (Body.Tell) body;
    Term agent = scope.apply(tell.agent());
    if (agent instanceof Term.Name name) {
      course.tell(path, name.text(), scope.apply(tell.message()), this::told);
    } else if (agent instanceof Term.Text name) {
      course.tell(path, name.value(), scope.apply(tell.message()), this::told);
    } else {
      finish(new Result.Failed("%s is no agent.".formatted(SlPrinter.print(agent))));
    }
  }

  private void told(Optional<String> problem) {
    finish(problem.<Result>map(Result.Failed::new).orElseGet(Result.Done::new));
  }

  /** What is on its way is not called back. */
  @Override
  void stop(Runnable then) {
    then.run();
  }
}
