package org.maestro.sim.life;

import java.util.Random;
import org.maestro.rats.time.Clock;
import org.maestro.sim.world.World;

/** The lives of all persons of a home who go about in it. */
public final class Life {
  private final World world;
  private final Clock clock;
  private final Random seeds;

  /**
   * @param seed of all that chance decides in them
   */
  public Life(World world, Clock clock, long seed) {
    this.world = world;
    this.clock = clock;
    this.seeds = new Random(seed);
  }

  /**
   * From now on a person goes about, until the world ends.
   *
   * @param staySeconds for how long she stays where she comes to, in the mean
   */
  public void begin(String person, double staySeconds) {
    Walker walker = new Walker(world, clock, person);
    new Inhabitant(walker, staySeconds, new Random(seeds.nextLong())).stay();
  }
}
