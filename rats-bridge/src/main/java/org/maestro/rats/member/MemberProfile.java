package org.maestro.rats.member;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;

/**
 * The profile from which the runtime makes a member, r = (Id, F, Z, z, Zs) (Three-layered
 * architecture, 3.2.1; M32).
 *
 * @param description the JSON-LD document published for MAESTRO
 * @param states Z; {@code safeStates} is a subset with at least one element (Three-layered
 *     architecture, 3.2.1; M36)
 * @param features F, by id
 * @param rules how z may change
 * @param takesOver features, some of its own, whose running calls to others it offers to take over
 *     when it could do them for less (Three-layered architecture, 3.2.1; M43)
 */
public record MemberProfile(
    String id,
    String description,
    Set<String> states,
    String initialState,
    Set<String> safeStates,
    Map<String, Feature> features,
    StateRules rules,
    Set<String> takesOver) {

  private static final Pattern FEATURE =
      Pattern.compile("[^$/+#\\s\\p{Cntrl}][^/+#\\s\\p{Cntrl}]{0,127}");
  private static final Pattern ID = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]{0,62}");

  /**
   * @throws IllegalArgumentException when the id or a feature's cannot be a level of a topic, a
   *     feature has a reserved name, there is no safe state, or a state is none of Z
   */
  public MemberProfile {
    if (!ID.matcher(id).matches()) {
      throw new IllegalArgumentException(
          "'" + id + "' is no member id: letters, digits, '.', '_' and '-', at most 63");
    }
    for (String feature : features.keySet()) {
      if (!FEATURE.matcher(feature).matches()) {
        throw new IllegalArgumentException(
            "'"
                + feature
                + "' of the member "
                + id
                + " is no feature name: 1 to 128 characters without space, '/', '+' and '#', and no"
                + " '$' first, which is reserved");
      }
    }
    if (safeStates.isEmpty()) {
      throw new IllegalArgumentException(
          "The member " + id + " has no safe state; its description must name one at least");
    }
    Set<String> used = new TreeSet<>(safeStates);
    used.add(initialState);
    used.addAll(rules.states());
    features = Collections.unmodifiableMap(new LinkedHashMap<>(features));
    features.forEach(
        (name, feature) -> {
          if (!feature.id().equals(name)) {
            throw new IllegalArgumentException(
                "The member %s lists its feature %s under the name %s"
                    .formatted(id, feature.id(), name));
          }
        });
    takesOver = Set.copyOf(takesOver);
    if (!features.keySet().containsAll(takesOver)) {
      throw new IllegalArgumentException(
          "The member %s would take over what it has no feature for: %s"
              .formatted(id, String.join(", ", new TreeSet<>(takesOver))));
    }
    Optional<String> unsafe =
        rules
            .lastResort()
            .map(StateRules.LastResort::state)
            .filter(state -> !safeStates.contains(state));
    if (unsafe.isPresent()) {
      throw new IllegalArgumentException(
          "The last resort of the member " + id + " is no safe state: " + unsafe.get());
    }
    features.values().forEach(feature -> used.add(feature.runningState()));
    used.removeAll(states);
    if (!used.isEmpty()) {
      throw new IllegalArgumentException(
          "The member " + id + " uses states that are none of its own: " + String.join(", ", used));
    }
  }

  /** Of a member whose states may follow each other freely. */
  public MemberProfile(
      String id,
      String description,
      Set<String> states,
      String initialState,
      Set<String> safeStates,
      Map<String, Feature> features) {
    this(id, description, states, initialState, safeStates, features, StateRules.FREE);
  }

  /** Of a member that leaves to others what they are at. */
  public MemberProfile(
      String id,
      String description,
      Set<String> states,
      String initialState,
      Set<String> safeStates,
      Map<String, Feature> features,
      StateRules rules) {
    this(id, description, states, initialState, safeStates, features, rules, Set.of());
  }

  /** The same member, which also offers to take over running calls of these features. */
  public MemberProfile takingOver(Set<String> wanted) {
    return new MemberProfile(
        id, description, states, initialState, safeStates, features, rules, wanted);
  }

  /**
   * F from a list, in its order.
   *
   * @throws IllegalArgumentException when two features have the same id (Three-layered
   *     architecture, 2; M11)
   */
  public static Map<String, Feature> byId(List<Feature> features) {
    Map<String, Feature> byId = new LinkedHashMap<>();
    for (Feature feature : features) {
      if (byId.put(feature.id(), feature) != null) {
        throw new IllegalArgumentException(
            "Two features are called " + feature.id() + "; each needs an id of its own");
      }
    }
    return byId;
  }

  /**
   * A feature as the runtime sees it.
   *
   * @param required names of the parameters that a call must carry
   * @param occupies components; two features that share one never run at the same time
   *     (Three-layered architecture, 3.2.1; M39)
   * @param continuous established first, ended by cancel or by {@code endedBy}
   * @param runningState z while it runs
   * @param frequency how often a continuous one tells a value
   */
  public record Feature(
      String id,
      Set<String> required,
      Set<String> occupies,
      boolean continuous,
      Optional<String> endedBy,
      String runningState,
      Procedure procedure,
      Frequency frequency) {

    /** One that tells what it observes whenever it does. */
    public Feature(
        String id,
        Set<String> required,
        Set<String> occupies,
        boolean continuous,
        Optional<String> endedBy,
        String runningState,
        Procedure procedure) {
      this(
          id,
          required,
          occupies,
          continuous,
          endedBy,
          runningState,
          procedure,
          Frequency.AS_IT_COMES);
    }
  }

  /** The current facts a member reports of itself, in MAESTRO-SL; asked on the clock thread. */
  public interface Values {
    List<String> current();
  }
}
