package org.maestro.coordination.scripts;

import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.api.Resource;
import org.maestro.sl.Body;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Parts that are done while a component is held for them; without parts, until it is let go. */
final class Holding extends Part {
  static final int STEPS = 1;

  private final Body.Hold hold;
  private final Scope scope;
  private Optional<Part> steps = Optional.empty();
  private Optional<Result> result = Optional.empty();
  private boolean asked;

  Holding(Body.Hold hold, Scope scope, Course course, String path, Consumer<Result> then) {
    super(course, path, then);
    this.hold = hold;
    this.scope = scope;
  }

  @Override
  void proceed() {
    Term member = scope.apply(hold.member());
    if (member instanceof Term.Name name) {
      asked = true;
      course.hold(path, Resource.component(name.text(), hold.component()), this::held, this::over);
    } else {
      finish(new Result.Failed("%s is no member.".formatted(SlPrinter.print(member))));
    }
  }

  private void held() {
    if (!isOver() && !hold.parts().isEmpty()) {
      Part part = course.part(new Body.Seq(hold.parts()), scope, below(STEPS), this::done);
      steps = Optional.of(part);
      part.begin();
    }
  }

  /** It is written down first: after a restart in between nothing of it is done again. */
  private void done(Result ended) {
    result = Optional.of(ended);
    course.notes().over(path, ended);
    course.letGo(path);
  }

  /** What it was held for is over. */
  void letGo() {
    if (asked && !isOver()) {
      done(new Result.Done());
    } else {
      finish(new Result.Done());
    }
  }

  private void over(Result ended) {
    if (result.isEmpty() && steps.isPresent()) {
      steps.get().callOff(() -> finish(ended));
    } else {
      finishUnwritten(result.orElse(ended));
    }
  }

  @Override
  void stop(Runnable then) {
    Runnable last =
        () -> {
          if (asked) {
            course.cancel(path);
          }
          then.run();
        };
    steps.ifPresentOrElse(part -> part.callOff(last), last);
  }
}
