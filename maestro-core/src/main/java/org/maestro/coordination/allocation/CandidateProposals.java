package org.maestro.coordination.allocation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Proposal;
import org.maestro.coordination.api.Roster;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;

/**
 * The contract net of one plan. Few candidates are called all at once. Of many, those are called
 * who could take part in a plan near the cheapest, by the prices of their descriptions; the others
 * count at these prices until a plan wants them. That there is no plan is said only when all were
 * called.
 */
public final class CandidateProposals implements ContractNet.Round {
  /** To plan twice costs less than to ask more. */
  private static final int FEW = 24;

  private final Map<String, List<String>> candidates;
  private final Roster roster;
  private final Set<String> called = new LinkedHashSet<>();
  private final Map<String, Proposal> bids = new LinkedHashMap<>();
  private final List<ContractNet.Round> rounds = new ArrayList<>();

  /**
   * @param candidates names of the features in question, by member
   */
  CandidateProposals(Map<String, List<String>> candidates, Roster roster) {
    this.candidates = candidates;
    this.roster = roster;
  }

  /** Whom to call before anything is planned. */
  Set<String> atFirst() {
    return candidates.size() <= FEW ? candidates.keySet() : Set.of();
  }

  /** Whom to call now that this was planned with what is known; empty: it may be relied on. */
  Set<String> wantedFor(PlanningResult result) {
    if (!(result instanceof PlanningResult.Found found)) {
      return uncalled(candidates.keySet());
    }
    boolean isOfCalled =
        found.plan().steps().stream().allMatch(step -> called.contains(step.member()));
    return isOfCalled ? Set.of() : uncalled(found.contenders());
  }

  private Set<String> uncalled(Set<String> members) {
    Set<String> uncalled = new LinkedHashSet<>(candidates.keySet());
    uncalled.retainAll(members);
    uncalled.removeAll(called);
    return uncalled;
  }

  boolean allCalled() {
    return called.size() == candidates.size();
  }

  /** Present ones that were not called, since the plan is cheaper without them. */
  public int notCalled() {
    return (int)
        candidates.keySet().stream()
            .filter(member -> !called.contains(member) && roster.isPresent(member))
            .count();
  }

  Map<String, List<String>> featuresOf(Set<String> members) {
    Map<String, List<String>> features = new LinkedHashMap<>(candidates);
    features.keySet().retainAll(members);
    return features;
  }

  void add(Set<String> members, ContractNet.Round round) {
    called.addAll(members);
    rounds.add(round);
    round.bids().forEach(bid -> bids.put(bid.member(), bid));
  }

  /** What is offered, in the order of the devices. */
  List<PricedFeature> features(Home home, ExactPrices exactPrices) {
    List<Device> devices = new ArrayList<>(home.devices().values());
    devices.sort(Comparator.comparingDouble(Device::order).thenComparing(Device::id));
    List<PricedFeature> features = new ArrayList<>();
    for (Device device : devices) {
      for (FeatureType type : device.features()) {
        price(device.id(), type)
            .map(
                p ->
                    new PricedFeature(
                        device.id(), type, p, exactPrices.of(device.id(), type.name())))
            .ifPresent(features::add);
      }
    }
    return features;
  }

  private Optional<Price> price(String member, FeatureType type) {
    if (called.contains(member)) {
      return bid(member).flatMap(bid -> Optional.ofNullable(bid.prices().get(type.name())));
    }
    return candidates.getOrDefault(member, List.of()).contains(type.name())
            && roster.isPresent(member)
        ? Optional.of(type.cost())
        : Optional.empty();
  }

  Optional<Proposal> bid(String member) {
    return Optional.ofNullable(bids.get(member));
  }

  /** Candidates that cannot be counted on: absent, silent, or refusing. */
  List<String> missing() {
    return candidates.keySet().stream()
        .filter(member -> called.contains(member) || !roster.isPresent(member))
        .filter(member -> bid(member).map(bid -> bid.refusal().isPresent()).orElse(true))
        .toList();
  }

  List<String> candidateFeatures(String member) {
    return candidates.getOrDefault(member, List.of());
  }

  @Override
  public List<Proposal> bids() {
    return List.copyOf(bids.values());
  }

  @Override
  public void award(Map<String, List<Step>> parts) {
    rounds.forEach(round -> round.award(parts));
  }
}
