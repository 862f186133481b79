package org.maestro.coordination.scripts;

import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.api.Respondent;
import org.maestro.sl.Body;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * A question to people, and parts that know the answer. It is open until somebody answers it with
 * what would do, or it is called off. After a restart the same question is asked again, and an
 * answer that was taken is not asked for again.
 */
final class Asking extends Part {
  static final int PARTS = 1;

  private final Body.Ask ask;
  private final Scope scope;
  private Optional<Part> parts = Optional.empty();

  Asking(Body.Ask ask, Scope scope, Course course, String path, Consumer<Result> then) {
    super(course, path, then);
    this.ask = ask;
    this.scope = scope;
  }

  @Override
  void proceed() {
    Optional<Term> noted = course.notes().value(path);
    Term who = scope.apply(ask.who());
    if (noted.isPresent()) {
      goOn(noted.get());
    } else if (who instanceof Term.Name name) {
      course.takesTime();
      Question question =
          new Question(
              name.text(),
              scope.apply(ask.words()),
              ask.type(),
              ask.format().map(scope::apply),
              this::answered);
      course.voice().ask(path, question, problem -> finish(new Result.Failed(problem)));
    } else {
      finish(new Result.Failed("%s hears nothing.".formatted(SlPrinter.print(who))));
    }
  }

  /** It is kept first: who is told that it is taken can rely on it. */
  private void answered(Term answer, Respondent by, Runnable taken) {
    Term who = scope.apply(ask.who());
    course
        .voice()
        .keep(
            path,
            SlPrinter.print(who),
            scope.apply(ask.words()),
            answer,
            by,
            () -> {
              if (!isOver()) {
                course.notes().value(path, answer);
                course
                    .told()
                    .answers(path, ask.answer().name(), SlPrinter.print(answer), by.name());
                goOn(answer);
              }
              taken.run();
            });
  }

  private void goOn(Term answer) {
    Part part =
        course.part(
            new Body.Seq(ask.parts()),
            scope.with(ask.answer().name(), answer),
            below(PARTS),
            this::finish);
    parts = Optional.of(part);
    part.begin();
  }

  @Override
  void stop(Runnable then) {
    course.voice().withdraw(path);
    parts.ifPresentOrElse(part -> part.callOff(then), then);
  }
}
