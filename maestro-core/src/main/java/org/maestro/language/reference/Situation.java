package org.maestro.language.reference;

import java.util.Optional;
import java.util.OptionalInt;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Facts;

/**
 * Where and when something is said, and what is known then.
 *
 * @param speaker who speaks
 * @param here the room or zone in which it is said
 * @param self the robot or agent spoken to
 * @param minuteOfDay what the clock shows; 0 is midnight
 * @param discourse what was spoken of before
 */
public record Situation(
    Home home,
    Facts facts,
    Optional<String> speaker,
    Optional<String> here,
    Optional<String> self,
    OptionalInt minuteOfDay,
    Discourse discourse) {

  /** The same, where somebody else speaks. */
  public Situation spokenBy(String other) {
    return new Situation(home, facts, Optional.of(other), here, self, minuteOfDay, discourse);
  }

  /** The same, as if it were said in another room. */
  public Situation saidIn(String room) {
    return new Situation(home, facts, speaker, Optional.of(room), self, minuteOfDay, discourse);
  }

  /** The same after something was spoken of. */
  public Situation after(Discourse later) {
    return new Situation(home, facts, speaker, here, self, minuteOfDay, later);
  }
}
