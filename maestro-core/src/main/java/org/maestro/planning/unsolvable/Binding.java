package org.maestro.planning.unsolvable;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;
import org.maestro.planning.ground.Atom;
import org.maestro.planning.ground.Schema;

/** What the parameters of a schema stand for: an object's number, or below 0 what is open. */
final class Binding {
  private static final int OPEN = -1;

  private Binding() {}

  static int[] open(Schema schema) {
    int[] binding = new int[schema.domains().size()];
    Arrays.fill(binding, OPEN);
    return binding;
  }

  static int[] objects(Atom atom, int[] binding) {
    return Arrays.stream(atom.terms())
        .map(term -> Atom.isParameter(term) ? binding[Atom.parameterOf(term)] : term)
        .toArray();
  }

  /** What the schema's parameters are where its atom is about these objects, if it can be. */
  static Optional<int[]> with(Schema schema, Atom atom, int[] objects) {
    int[] binding = open(schema);
    for (int i = 0; i < objects.length; i++) {
      int term = atom.terms()[i];
      if (objects[i] < 0) {
        continue;
      }
      if (!Atom.isParameter(term)) {
        if (term != objects[i]) {
          return Optional.empty();
        }
        continue;
      }
      int parameter = Atom.parameterOf(term);
      boolean isOther = binding[parameter] >= 0 && binding[parameter] != objects[i];
      if (isOther || !schema.domains().get(parameter).get(objects[i])) {
        return Optional.empty();
      }
      binding[parameter] = objects[i];
    }
    return Optional.of(binding);
  }

  /** The first parameter that is open and that conditions speak of; below 0 if there is none. */
  static int firstOpen(Schema schema, int[] binding) {
    return IntStream.range(0, binding.length)
        .filter(parameter -> binding[parameter] < 0)
        .filter(
            parameter ->
                schema.conditions().stream()
                    .flatMapToInt(part -> Arrays.stream(part.atom().terms()))
                    .anyMatch(term -> term == Atom.parameter(parameter)))
        .findFirst()
        .orElse(OPEN);
  }
}
