package org.maestro.members;

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
public final class MemberView {
  private Optional<Device> device = Optional.empty();
  private boolean ready;
  private int running;
  private final List<String> heldBack = new ArrayList<>();
  private final Map<String, Map<String, Term>> bindingsByConversation = new TreeMap<>();

  public Optional<Device> device() {
    return device;
  }

  public void describedAs(Device described) {
    device = Optional.of(described);
  }

  public boolean isReady() {
    return ready && device.isPresent();
  }

  /**
   * @param now false when it is lost: what it said of itself before, and what waits for a report
   *     that will not come any more, is no news then
   */
  public void ready(boolean now) {
    ready = now;
    if (!now) {
      heldBack.clear();
    }
  }

  public Optional<FeatureType> feature(String name) {
    return device.stream()
        .flatMap(d -> d.features().stream())
        .filter(f -> f.name().equals(name))
        .findFirst();
  }

  public void begun(String conversation, Map<String, Term> bindings) {
    running++;
    bindingsByConversation.put(conversation, bindings);
  }

  /** The call is over, or established; returns what the member said of itself meanwhile. */
  public List<String> over() {
    running--;
    List<String> facts = List.copyOf(heldBack);
    if (running == 0) {
      heldBack.clear();
      return facts;
    }
    return List.of();
  }

  public void forget(String conversation) {
    bindingsByConversation.remove(conversation);
  }

  public Map<String, Term> bindings(String conversation) {
    return bindingsByConversation.getOrDefault(conversation, Map.of());
  }

  /**
   * While a call runs, what the member says of itself waits for the call's report, so that
   * knowledge never shows half a step.
   *
   * @return the facts that may be told now
   */
  public List<String> said(List<String> facts) {
    if (running == 0) {
      return facts;
    }
    heldBack.clear();
    heldBack.addAll(facts);
    return List.of();
  }
}
