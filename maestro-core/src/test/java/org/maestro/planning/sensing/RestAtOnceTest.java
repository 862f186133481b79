package org.maestro.planning.sensing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.maestro.planning.SearchHomes;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.optimal.RelaxedProblem;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Sought;

/**
 * What comes after a look is the same whether it is reckoned anew for each place or brought up to
 * date from what is so at every place.
 */
class RestAtOnceTest {
  private static final int HOMES = 150;

  @Test
  void isWhatIsReckonedAnew() {
    int finite = 0;
    for (int seed = 1; seed <= HOMES; seed++) {
      SearchHomes.SearchHome home = SearchHomes.home(new Random(seed), 2 + seed % 6, 1 + seed % 2);
      GroundProblem problem = new Grounder(home.world().task(home.goal())).ground().placed();
      RelaxedProblem relaxed = new RelaxedProblem(problem);
      for (Sought sought : Sought.of(problem)) {
        LookCosts costs = new LookCosts(problem, relaxed, sought);
        for (int twice = 0; twice < 2; twice++) {
          for (int place = 0; place < sought.values().size(); place++) {
            double anew = costs.rest(costs.initial(), costs.initial(), place).sum();
            assertThat(costs.restAtOnce(place).sum())
                .as("home %d, %s at %s", seed, sought.variable(), sought.terms().get(place))
                .isEqualTo(anew, within(1e-9));
            finite += Double.isFinite(anew) ? 1 : 0;
          }
        }
      }
    }
    assertThat(finite).isGreaterThan(HOMES);
  }
}
