package org.maestro.rats.link;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The listeners for news of members: of all, or of one. Clock thread only. */
final class Watchers {
  private final List<RatsLink.MemberListener> ofAll = new ArrayList<>();
  private final Map<String, List<RatsLink.MemberListener>> ofOne = new HashMap<>();

  void add(RatsLink.MemberListener listener) {
    ofAll.add(listener);
  }

  void add(String member, RatsLink.MemberListener listener) {
    ofOne.computeIfAbsent(member, id -> new ArrayList<>(1)).add(listener);
  }

  void remove(String member, RatsLink.MemberListener listener) {
    List<RatsLink.MemberListener> its = ofOne.get(member);
    if (its != null && its.remove(listener) && its.isEmpty()) {
      ofOne.remove(member);
    }
  }

  /** Those of all first, each in the order in which they came. */
  void changed(RatsLink.Member member) {
    of(member.id()).forEach(listener -> listener.changed(member));
  }

  /** In the same order. */
  void alerted(String member, String callId, String message) {
    of(member).forEach(listener -> listener.alerted(member, callId, message));
  }

  private List<RatsLink.MemberListener> of(String member) {
    List<RatsLink.MemberListener> its = new ArrayList<>(ofAll);
    its.addAll(ofOne.getOrDefault(member, List.of()));
    return its;
  }
}
