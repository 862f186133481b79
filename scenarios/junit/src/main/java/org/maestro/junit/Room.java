package org.maestro.junit;

import java.time.Duration;
import org.maestro.assembly.LocalSite;
import org.maestro.sim.world.World;

/**
 * A room of the home, as somebody in it finds it: the truth, not what is known. For the test's
 * thread.
 */
public final class Room {
  private final LocalSite site;
  private final String room;
  private final Hearing hearing;
  private final Duration since;

  Room(LocalSite site, String room, Duration patience) {
    this.site = site;
    this.room = room;
    this.hearing = new Hearing(site, "In " + room + " one", patience);
    this.since = site.clock().now();
    hearing.listen(speech -> speech.to().equals(room) || holds(speech.to()));
  }

  private World world() {
    return site.world();
  }

  /**
   * Lets time pass until this sentence is said there, to all or to somebody who is in it, after all
   * that was waited for before; fails the test when it is not.
   */
  public Awaited awaits(String sentence) {
    return hearing.await(sentence, since);
  }

  /** Nothing was said there; fails the test when something was. */
  public Room hasHeardNothing() {
    hearing.requireNothing();
    return this;
  }

  /** How light it is. */
  public double lux() {
    return world().lux(room);
  }

  /** Whether a person, a robot or a thing is in it, by its name in the home. */
  public boolean holds(String one) {
    return world().zone(one).filter(room::equals).isPresent();
  }
}
