package org.maestro.coordination.scripts;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.maestro.coordination.achievement.FeatureCall;
import org.maestro.sl.Body;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** A part that acts: a goal of its own, whose end is written down by itself. */
final class Deed extends Part {
  private final Body body;
  private final Scope scope;
  private boolean begun;

  Deed(Body body, Scope scope, Course course, String path, Consumer<Result> then) {
    super(course, path, then);
    this.body = body;
    this.scope = scope;
  }

  @Override
  void proceed() {
    if (body instanceof Body.Achieve achieve) {
      begun = true;
      course.achieve(path, scope.apply(achieve.goal()), this::finishUnwritten);
      return;
    }
    if (body instanceof Body.Look look) {
      look(scope.apply(look.thing()));
      return;
    }
    Body.Do call = (Body.Do) body;
    Term member = scope.apply(call.member());
    Optional<Term> open =
        call.parameters().values().stream()
            .map(scope::apply)
            .filter(Term.Variable.class::isInstance)
            .findFirst();
    if (!(member instanceof Term.Name name)) {
      finish(new Result.Failed("%s is no member.".formatted(SlPrinter.print(member))));
    } else if (open.isPresent()) {
      finish(new Result.Failed("%s stands for nothing.".formatted(SlPrinter.print(open.get()))));
    } else {
      begun = true;
      Map<String, Term> parameters = new TreeMap<>();
      call.parameters().forEach((key, term) -> parameters.put(key, scope.apply(term)));
      course.call(
          path, new FeatureCall(call.feature(), name.text(), parameters), this::finishUnwritten);
    }
  }

  private void look(Term thing) {
    Optional<Sighting> sighting =
        thing instanceof Term.Name name ? course.sighting(name.text()) : Optional.empty();
    if (sighting.isEmpty()) {
      finish(
          new Result.Failed(
              "Nobody here can look for anything of %s.".formatted(SlPrinter.print(thing))));
    } else {
      begun = true;
      course.look(path, sighting.get(), this::finishUnwritten);
    }
  }

  @Override
  void stop(Runnable then) {
    if (begun) {
      course.cancel(path);
    }
    then.run();
  }
}
