package org.maestro.coordination.scripts;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.maestro.sl.Body;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * A variable that stands for what is found, or for what another script gives, and parts with it.
 */
final class Let extends Part {
  static final int SOURCE = 1;
  static final int PARTS = 2;

  private final Body.Let let;
  private final Scope scope;
  private Optional<Part> current = Optional.empty();

  Let(Body.Let let, Scope scope, Course course, String path, Consumer<Result> then) {
    super(course, path, then);
    this.let = let;
    this.scope = scope;
  }

  @Override
  void proceed() {
    Optional<Term> noted = course.notes().value(path);
    if (noted.isPresent()) {
      goOn(noted.get());
    } else if (let.source() instanceof Body.Run run) {
      begin(new RunScript(run, scope, course, below(SOURCE), this::ran));
    } else if (let.source() instanceof Body.Source.Value value) {
      OptionalDouble number = course.number(value.number(), scope);
      if (number.isPresent()) {
        found(new Term.Number(number.getAsDouble()));
      } else {
        fail("%s is not known.".formatted(SlPrinter.print(scope.apply(value.number()))));
      }
    } else {
      Body.Source.One one = (Body.Source.One) let.source();
      List<Term.Name> names = course.individuals(one.variable(), one.condition(), scope);
      if (names.isEmpty()) {
        fail(
            "There is no %s of which it is known that %s."
                .formatted(
                    SlPrinter.print(one.variable()),
                    SlPrinter.print(scope.apply(one.condition()))));
      } else {
        found(names.get(0));
      }
    }
  }

  private void fail(String reason) {
    finish(new Result.Failed(reason));
  }

  private void ran(Result result) {
    if (result instanceof Result.Returned returned) {
      found(returned.value());
    } else if (result instanceof Result.Failed) {
      finish(result);
    } else {
      fail("The script %s gave nothing.".formatted(((Body.Run) let.source()).script()));
    }
  }

  private void found(Term value) {
    course.notes().value(path, value);
    course.told().gives(path, let.variable(), SlPrinter.print(value));
    goOn(value);
  }

  private void goOn(Term value) {
    begin(
        course.part(
            new Body.Seq(let.parts()),
            scope.with(let.variable(), value),
            below(PARTS),
            this::finish));
  }

  private void begin(Part part) {
    current = Optional.of(part);
    part.begin();
  }

  @Override
  void stop(Runnable then) {
    current.ifPresentOrElse(part -> part.callOff(then), then);
  }
}
