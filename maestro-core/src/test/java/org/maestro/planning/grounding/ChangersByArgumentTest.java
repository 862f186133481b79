package org.maestro.planning.grounding;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.maestro.sl.Term;

/** Who may change what, looked up by its arguments: nobody is missed, whoever came before. */
class ChangersByArgumentTest {
  private static final int VALUES = 4;
  private static final int FEATURES = 12;

  @Property(tries = 500)
  void thoseAreFoundWhoseValuesTheArgumentsAre(@ForAll Random random) {
    List<List<Optional<Set<Term>>>> reach = new ArrayList<>();
    for (int number = 0; number < FEATURES; number++) {
      reach.add(IntStream.range(0, random.nextInt(4)).mapToObj(place -> values(random)).toList());
    }
    ChangersByArgument changers = new ChangersByArgument(reach::get);
    for (int question = 0; question < 10; question++) {
      List<Integer> there =
          IntStream.range(0, FEATURES).filter(number -> random.nextBoolean()).boxed().toList();
      List<Term> arguments =
          IntStream.range(0, random.nextInt(4)).mapToObj(place -> value(random)).toList();

      List<Integer> found = changers.of(there, arguments);

      assertThat(found).doesNotHaveDuplicates();
      assertThat(found.stream().filter(there::contains))
          .containsExactlyInAnyOrderElementsOf(
              there.stream().filter(number -> admits(reach.get(number), arguments)).toList());
    }
  }

  private static boolean admits(List<Optional<Set<Term>>> reach, List<Term> arguments) {
    return IntStream.range(0, Math.min(reach.size(), arguments.size()))
        .allMatch(
            place -> reach.get(place).map(all -> all.contains(arguments.get(place))).orElse(true));
  }

  private static Optional<Set<Term>> values(Random random) {
    if (random.nextInt(3) == 0) {
      return Optional.empty();
    }
    Set<Term> values = new HashSet<>();
    for (int i = random.nextInt(VALUES); i > 0; i--) {
      values.add(value(random));
    }
    return Optional.of(values);
  }

  private static Term value(Random random) {
    return new Term.Name("v" + random.nextInt(VALUES));
  }
}
