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
        course.voice().say(path, name.text(), scope.apply(say.words()), this::told);
      } else {
        finish(new Result.Failed("%s hears nothing.".formatted(SlPrinter.print(who))));
      }
      return;
    }
    if (body instanceof Body.Express express) {
      show(word(scope.apply(express.word())), scope.apply(express.intensity()));
      return;
    }
    Body.Tell tell = (Body.Tell) body;
    Term agent = scope.apply(tell.agent());
    word(agent)
        .ifPresentOrElse(
            name -> course.voice().tell(path, name, scope.apply(tell.message()), this::told),
            () -> finish(new Result.Failed("%s is no agent.".formatted(SlPrinter.print(agent)))));
  }

  private void show(Optional<String> word, Term intensity) {
    if (word.isPresent()
        && intensity instanceof Term.Number number
        && number.value() >= 0
        && number.value() <= 1) {
      course.voice().express(path, word.get(), number.value(), this::told);
    } else {
      finish(
          new Result.Failed(
              "%s is no number from 0 to 1, by which something could be shown."
                  .formatted(SlPrinter.print(intensity))));
    }
  }

  private static Optional<String> word(Term term) {
    if (term instanceof Term.Name name) {
      return Optional.of(name.text());
    }
    return term instanceof Term.Text text ? Optional.of(text.value()) : Optional.empty();
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
