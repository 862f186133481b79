package org.maestro.knowledge.belief;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.knowledge.api.Moment;
import org.maestro.knowledge.api.StateVariable;

/**
 * The last messages in which a member told of each variable, by the member's own order: what was
 * said earlier and comes to be known later is no news. One writer at a time.
 */
public final class LastWords {

  private final Map<String, Map<StateVariable, Moment>> toldByMember = new TreeMap<>();
  private final Map<String, MemberWord> heardByMember = new TreeMap<>();
  private final Map<String, Map<StateVariable, Moment>> taughtByMember = new TreeMap<>();
  private final Set<String> lost = new HashSet<>();

  /** Returns whether nothing later was told of it; then this is what was told last. */
  public boolean takes(String member, StateVariable variable, Moment moment) {
    boolean outdated = last(member, variable).filter(last -> last.isAfter(moment)).isPresent();
    if (!outdated) {
      toldByMember.computeIfAbsent(member, m -> new HashMap<>()).put(variable, moment);
    }
    return !outdated;
  }

  /** The member said of itself all that it tells. */
  public void heard(String member, MemberWord word) {
    lost.remove(member);
    heardByMember.merge(
        member, word, (one, next) -> one.moment().isAfter(next.moment()) ? one : next);
  }

  /** Whether the member is gone, and has said nothing since. */
  public boolean isLost(String member) {
    return lost.contains(member);
  }

  public Optional<MemberWord> lastHeard(String member) {
    return Optional.ofNullable(heardByMember.get(member));
  }

  /** The result of a step that changes the variable was the message. */
  public void taught(String member, StateVariable variable, Moment ended) {
    takes(member, variable, ended);
    taughtByMember
        .computeIfAbsent(member, m -> new HashMap<>())
        .merge(variable, ended, (one, next) -> one.isAfter(next) ? one : next);
  }

  public Optional<Moment> last(String member, StateVariable variable) {
    return Optional.ofNullable(toldByMember.getOrDefault(member, Map.of()).get(variable));
  }

  /** The latest result of a step that changed it. */
  public Optional<Moment> lastTaught(String member, StateVariable variable) {
    return Optional.ofNullable(taughtByMember.getOrDefault(member, Map.of()).get(variable));
  }

  public void forget(String member) {
    lost.add(member);
    toldByMember.remove(member);
    heardByMember.remove(member);
    taughtByMember.remove(member);
  }
}
