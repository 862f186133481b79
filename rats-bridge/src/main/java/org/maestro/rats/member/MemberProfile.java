package org.maestro.rats.member;

import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What the runtime must know of a member, r = (Id, F, Z, z, Zs) (M32).
 *
 * @param description the JSON-LD document published for MAESTRO
 * @param states Z; {@code safeStates} is a subset with at least one element (M36)
 * @param features F, by id
 */
public record MemberProfile(
    String id,
    String description,
    Set<String> states,
    String initialState,
    Set<String> safeStates,
    Map<String, Feature> features) {

  /**
   * A feature as the runtime sees it.
   *
   * @param required names of the parameters that a call must carry
   * @param occupies components; two features that share one never run at the same time (M39)
   * @param continuous established first, ended by cancel or by {@code endedBy}
   * @param runningState z while it runs
   */
  public record Feature(
      String id,
      Set<String> required,
      Set<String> occupies,
      boolean continuous,
      java.util.Optional<String> endedBy,
      String runningState,
      Procedure procedure) {}

  /** The current facts a member reports of itself, in MAESTRO-SL; asked on the clock thread. */
  public interface Values {
    List<String> current();
  }
}
