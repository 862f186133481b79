package org.maestro.agents;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Term;

/**
 * What a generic agent knows of the member it stands for: what it described, and what runs on it.
 * Agent thread only.
 */
final class MemberView {
  private Optional<Device> device = Optional.empty();
  private boolean ready;
  private int running;
  private final List<String> heldBack = new ArrayList<>();
  private final Map<String, Map<String, Term>> bindingsByConversation = new TreeMap<>();

  Optional<Device> device() {
    return device;
  }

  void describedAs(Device described) {
    device = Optional.of(described);
  }

  boolean isReady() {
    return ready && device.isPresent();
  }

  void ready(boolean now) {
    ready = now;
  }

  Optional<FeatureType> feature(String name) {
    return device.stream()
        .flatMap(d -> d.features().stream())
        .filter(f -> f.name().equals(name))
        .findFirst();
  }

  void begun(String conversation, Map<String, Term> bindings) {
    running++;
    bindingsByConversation.put(conversation, bindings);
  }

  /** The call is over, or established; returns what the member said of itself meanwhile. */
  List<String> over() {
    running--;
    List<String> facts = List.copyOf(heldBack);
    if (running == 0) {
      heldBack.clear();
      return facts;
    }
    return List.of();
  }

  void forget(String conversation) {
    bindingsByConversation.remove(conversation);
  }

  Map<String, Term> bindings(String conversation) {
    return bindingsByConversation.getOrDefault(conversation, Map.of());
  }

  /**
   * While a call runs, what the member says of itself waits for the call's report, so that
   * knowledge never shows half a step.
   *
   * @return the facts that may be told now
   */
  List<String> said(List<String> facts) {
    if (running == 0) {
      return facts;
    }
    heldBack.clear();
    heldBack.addAll(facts);
    return List.of();
  }
}
