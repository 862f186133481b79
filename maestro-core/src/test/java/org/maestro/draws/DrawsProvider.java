package org.maestro.draws;

import java.util.Random;
import java.util.Set;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.RandomDistribution;
import net.jqwik.api.providers.ArbitraryProvider;
import net.jqwik.api.providers.TypeUsage;

/** Gives {@code @ForAll Random} choices that can be shrunk, which a seed cannot. */
public final class DrawsProvider implements ArbitraryProvider {
  private static final int MOST_DRAWS = 600;

  @Override
  public boolean canProvideFor(TypeUsage type) {
    return type.isOfType(Random.class);
  }

  /** Before jqwik's own. */
  @Override
  public int priority() {
    return 1;
  }

  @Override
  public Set<Arbitrary<?>> provideFor(TypeUsage type, SubtypeProvider subtypes) {
    return Set.of(
        Arbitraries.integers()
            .withDistribution(RandomDistribution.uniform())
            .list()
            .ofMaxSize(MOST_DRAWS)
            .withSizeDistribution(RandomDistribution.uniform())
            .map(Draws::new)
            .withoutEdgeCases());
  }
}
