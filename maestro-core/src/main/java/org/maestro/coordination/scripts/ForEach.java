package org.maestro.coordination.scripts;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.maestro.sl.Body;
import org.maestro.sl.Term;

/** A part for each of the individuals that were there when it began, one after the other. */
final class ForEach extends Part {
  private static final String BLANK = " ";

  private final Body.ForEach each;
  private final Scope scope;
  private Optional<Part> current = Optional.empty();

  ForEach(Body.ForEach each, Scope scope, Course course, String path, Consumer<Result> then) {
    super(course, path, then);
    this.each = each;
    this.scope = scope;
  }

  @Override
  void proceed() {
    List<Term.Name> names =
        course
            .notes()
            .value(path)
            .map(ForEach::read)
            .orElseGet(() -> course.individuals(each.variable(), each.condition(), scope));
    course
        .notes()
        .value(
            path,
            new Term.Text(names.stream().map(Term.Name::text).collect(Collectors.joining(BLANK))));
    next(names, 0);
  }

  private static List<Term.Name> read(Term noted) {
    return List.of(((Term.Text) noted).value().split(BLANK)).stream()
        .filter(name -> !name.isEmpty())
        .map(Term.Name::new)
        .toList();
  }

  private void next(List<Term.Name> names, int at) {
    if (at == names.size()) {
      finish(new Result.Done());
      return;
    }
    course.steps().within(path, at + 1, each.body());
    Part part =
        course.part(
            each.body(),
            scope.with(each.variable().name(), names.get(at)),
            below(at + 1),
            result -> {
              if (result instanceof Result.Done) {
                next(names, at + 1);
              } else {
                finish(result);
              }
            });
    current = Optional.of(part);
    part.begin();
  }

  @Override
  void stop(Runnable then) {
    current.ifPresentOrElse(part -> part.callOff(then), then);
  }
}
