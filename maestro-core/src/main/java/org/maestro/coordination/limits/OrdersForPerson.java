package org.maestro.coordination.limits;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.Ports;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.permission.Restrictions;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;

/**
 * Orders of steps, none of which goes beyond what a person may have done, whoever has chosen it.
 * The coordinator's thread only.
 */
final class OrdersForPerson implements ActionDispatcher {
  private final Ports ports;
  private final Optional<String> person;

  /**
   * @param ports of a world without limits
   */
  OrdersForPerson(Ports ports, Optional<String> person) {
    this.ports = ports;
    this.person = person;
  }

  @Override
  public Handle perform(Request order, Consumer<Report> reported) {
    Optional<String> objection = order.ends() ? Optional.empty() : objection(order.step());
    if (objection.isEmpty()) {
      return ports.dispatcher().perform(order, reported);
    }
    Report refused =
        new Report(
            false,
            Map.of(),
            objection,
            List.of(),
            false,
            Optional.of(Refusal.AS_THINGS_ARE),
            false);
    ports.owner().execute(() -> reported.accept(refused));
    return () -> {};
  }

  private Optional<String> objection(Step step) {
    Home home = ports.knowledge().home();
    return Optional.ofNullable(home.devices().get(step.member()))
        .flatMap(device -> objection(step, device, home));
  }

  private Optional<String> objection(Step step, Device device, Home home) {
    return device.features().stream()
        .filter(feature -> feature.name().equals(step.feature().name()))
        .findFirst()
        .flatMap(
            feature ->
                Restrictions.of(home)
                    .objection(
                        person, device, feature, step.values(), ports.knowledge().snapshot()))
        .map(new ObjectionSentences(home)::shortly);
  }

  @Override
  public void callOff(String member, Call call) {
    ports.dispatcher().callOff(member, call);
  }

  @Override
  public void ask(String member, Runnable heard) {
    ports.dispatcher().ask(member, heard);
  }

  @Override
  public void alive(String goalId, String member, String feature) {
    ports.dispatcher().alive(goalId, member, feature);
  }

  @Override
  public boolean isOwed(String goalId, StepKey step) {
    return ports.dispatcher().isOwed(goalId, step);
  }

  @Override
  public List<Request> giveUpOwed(String goalId, Predicate<StepKey> unwanted) {
    return ports.dispatcher().giveUpOwed(goalId, unwanted);
  }

  @Override
  public void want(ComponentWant want) {
    ports.dispatcher().want(want);
  }

  @Override
  public void wantNoMore(String goalId, String member) {
    ports.dispatcher().wantNoMore(goalId, member);
  }

  @Override
  public void giveBack(String member, Set<String> components) {
    ports.dispatcher().giveBack(member, components);
  }
}
