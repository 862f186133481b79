package org.maestro.planning.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.search.TwoSidedKnapsack.Choice;
import org.maestro.planning.search.TwoSidedKnapsack.Option;

class TwoSidedKnapsackTest {
  @Property(tries = 300)
  void choosesWhatTryingEverythingChooses(@ForAll @IntRange(min = 0, max = 1_000_000) int seed) {
    Random random = new Random(seed);
    List<List<Option>> groups = groups(random, random.nextInt(8), 12);
    long least = random.nextInt(40) - 5;
    long most = least + random.nextInt(12);
    Optional<Choice> choice =
        TwoSidedKnapsack.solve(groups, least, most, GroundingBudget.endless());
    long expected = byTrying(groups, 0, 0, 0, least, most);
    assertThat(choice.map(Choice::cost).orElse(Long.MAX_VALUE)).isEqualTo(expected);
    choice.ifPresent(
        chosen -> {
          long gain = 0;
          for (int i = 0; i < groups.size(); i++) {
            gain += groups.get(i).get(chosen.options()[i]).gain();
          }
          assertThat(gain).isBetween(least, most);
        });
  }

  @Test
  void isExactForThirtyLamps() {
    List<List<Option>> groups = groups(new Random(7), 30, 100_000);
    long most = groups.stream().mapToLong(group -> group.get(1).gain()).sum();
    Optional<Choice> choice =
        TwoSidedKnapsack.solve(groups, most / 3, most / 3 + 3, GroundingBudget.endless());
    assertThat(choice).isPresent();
  }

  private static List<List<Option>> groups(Random random, int count, int mostGain) {
    List<List<Option>> groups = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      groups.add(
          List.of(new Option(0, 0), new Option(1 + random.nextInt(mostGain), random.nextInt(20))));
    }
    return groups;
  }

  private static long byTrying(
      List<List<Option>> groups, int group, long gain, long cost, long least, long most) {
    if (group == groups.size()) {
      return gain >= least && gain <= most ? cost : Long.MAX_VALUE;
    }
    long best = Long.MAX_VALUE;
    for (Option option : groups.get(group)) {
      best =
          Math.min(
              best,
              byTrying(groups, group + 1, gain + option.gain(), cost + option.cost(), least, most));
    }
    return best;
  }
}
