package org.maestro.coordination.limits;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Proposal;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.coordination.api.WithOthers;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.permission.Objection;
import org.maestro.ontology.permission.Restrictions;
import org.maestro.ontology.permission.Way;

/** A market on which nobody is asked for what a person may never have done. */
final class BidsForPerson implements ContractNet {
  private final Ports ports;
  private final Optional<String> person;
  private final Set<String> told = new HashSet<>();

  /**
   * @param ports of a world without limits
   */
  BidsForPerson(Ports ports, Optional<String> person) {
    this.ports = ports;
    this.person = person;
  }

  @Override
  public void callForPrices(CallForPrices call, Consumer<Round> closed) {
    tellLimits(call);
    Map<String, List<String>> permitted = new TreeMap<>();
    List<Proposal> refusals = new ArrayList<>();
    call.features()
        .forEach(
            (member, features) -> {
              Map<String, Objection> objections = objections(member, features);
              List<String> left = new ArrayList<>(features);
              left.removeAll(objections.keySet());
              if (!left.isEmpty()) {
                permitted.put(member, List.copyOf(left));
              } else {
                refusals.add(new Proposal(member, Map.of(), reason(objections)));
              }
            });
    if (permitted.equals(call.features())) {
      ports.contractNet().callForPrices(call, closed);
    } else {
      ports
          .contractNet()
          .callForPrices(
              new CallForPrices(call.goalId(), call.goal(), permitted),
              round -> closed.accept(new WithOthers(round, refusals)));
    }
  }

  /** Where there is no plan within them, that may be why. */
  private void tellLimits(CallForPrices call) {
    Home home = ports.knowledge().home();
    Restrictions restrictions = Restrictions.of(home);
    Set<String> names = new TreeSet<>();
    call.features()
        .forEach(
            (member, features) ->
                Optional.ofNullable(home.devices().get(member)).stream()
                    .flatMap(
                        device ->
                            device.features().stream().map(f -> new Way(device, f, Map.of(), "")))
                    .filter(way -> features.contains(way.feature().name()))
                    .forEach(
                        way ->
                            names.addAll(restrictions.names(person, way.device(), way.feature()))));
    if (!names.isEmpty() && told.add(call.goalId())) {
      ports
          .story()
          .tell(
              new StoryEntry(
                  call.goalId(),
                  ports.clock().now(),
                  StoryEntry.Kind.KNOWN,
                  new ObjectionSentences(home).within(person, names)));
    }
  }

  private Map<String, Objection> objections(String member, List<String> features) {
    Home home = ports.knowledge().home();
    Map<String, Objection> objections = new TreeMap<>();
    Device device = home.devices().get(member);
    if (device != null) {
      Restrictions restrictions = Restrictions.of(home);
      device.features().stream()
          .filter(feature -> features.contains(feature.name()))
          .forEach(
              feature ->
                  restrictions
                      .objection(person, device, feature)
                      .ifPresent(objection -> objections.put(feature.name(), objection)));
    }
    return objections;
  }

  private Optional<String> reason(Map<String, Objection> objections) {
    return objections.values().stream()
        .findFirst()
        .map(new ObjectionSentences(ports.knowledge().home())::shortly);
  }

  @Override
  public void exactPrices(
      String goalId,
      String member,
      String feature,
      List<Map<String, Argument>> sets,
      Consumer<List<Quote>> answer) {
    ports.contractNet().exactPrices(goalId, member, feature, sets, answer);
  }
}
