package org.maestro.rats.gateway;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.maestro.rats.member.CallPolicy;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Transport;

/**
 * One lamp as a member: a call is an order to the gateway, and has succeeded when the lamp says
 * that it gives the light. Clock thread only.
 */
final class LampMember implements Procedure {

  private static final String STANDBY = "standby";
  private static final String SWITCHING = "switching";

  /** ZigBee sends again for some seconds; after that the lamp does not hear. */
  private static final Duration ANSWERS_WITHIN = Duration.ofSeconds(10);

  private static final Duration ASKS_AGAIN_AFTER = Duration.ofSeconds(2);
  private static final Duration ASKS_AT_LEAST_EVERY = Duration.ofMinutes(5);

  private final ZigbeeLamp lamp;
  private final String id;
  private final LampRole role;
  private final Gateway gateway;
  private final Clock clock;
  private final Insistence asking;
  private Optional<Double> level = Optional.empty();

  /** Whether it was heard since it can be reached. */
  private boolean heard;

  private Optional<Underway> underway = Optional.empty();

  /** Made after this, as it is told of this. */
  private @Nullable RatsMember member;

  private record Underway(Execution execution, double level) {}

  /** The channel to the gateway for this lamp's orders and questions. */
  interface Gateway {
    void set(JsonNode order);

    /** To say what light the lamp gives. */
    void ask();
  }

  private LampMember(ZigbeeLamp lamp, String id, LampRole role, Gateway gateway, Clock clock) {
    this.lamp = lamp;
    this.id = id;
    this.role = role;
    this.gateway = gateway;
    this.clock = clock;
    this.asking = new Insistence(id, gateway::ask, ASKS_AGAIN_AFTER, ASKS_AT_LEAST_EVERY, clock);
  }

  /** Joins the site; it is unknown yet whether the lamp can be reached. */
  static LampMember start(
      ZigbeeLamp lamp,
      String id,
      LampRole role,
      Gateway gateway,
      Transport transport,
      String site,
      CallPolicy policy,
      Complaints complaints,
      Clock clock) {
    LampMember started = new LampMember(lamp, id, role, gateway, clock);
    MemberProfile.Feature feature =
        new MemberProfile.Feature(
            role.feature(),
            Set.of(role.parameter()),
            Set.of("light"),
            false,
            Optional.empty(),
            SWITCHING,
            started);
    MemberProfile profile =
        new MemberProfile(
            id,
            role.description(id, lamp),
            Set.of(STANDBY, SWITCHING),
            STANDBY,
            Set.of(STANDBY),
            MemberProfile.byId(List.of(feature)));
    started.member =
        RatsMember.start(profile, started::facts, transport, site, policy, complaints, clock);
    return started;
  }

  ZigbeeLamp lamp() {
    return lamp;
  }

  private RatsMember member() {
    return Objects.requireNonNull(member);
  }

  void heard(JsonNode state) {
    lamp.level(state)
        .ifPresent(
            said -> {
              heard = true;
              asking.end();
              level = Optional.of(said);
              member().stateChanged();
              underway
                  .filter(order -> lamp.follows(order.level, said))
                  .ifPresent(
                      order -> {
                        underway = Optional.empty();
                        order.execution.succeed(Map.of());
                      });
            });
  }

  /**
   * @param why empty: it can be reached
   */
  void reachable(Optional<String> why) {
    why.ifPresentOrElse(this::away, this::back);
  }

  private void away(String reason) {
    heard = false;
    asking.end();
    member().disable(role.feature(), reason);
    giveUp(reason);
  }

  /** What it said while it was away, or this bridge was, nobody heard. */
  private void back() {
    member().enable(role.feature());
    if (!heard) {
      asking.begin();
    }
  }

  /** Any thread. */
  void leave() {
    clock.schedule(Duration.ZERO, id, asking::end);
    member().close();
  }

  @Override
  public void start(Execution execution) {
    Optional<Double> wanted = share(execution.call().parameters());
    if (wanted.isEmpty()) {
      execution.fail(
          error(ErrorCode.INVALID_PARAMETERS, role.parameter() + " is a number from 0 to 1"));
      return;
    }
    Underway order = new Underway(execution, wanted.get());
    underway = Optional.of(order);
    execution.onCancel(
        safe -> {
          underway = underway.filter(now -> !now.equals(order));
          safe.run();
        });
    gateway.set(lamp.order(wanted.get()));
    clock.schedule(
        ANSWERS_WITHIN,
        id,
        () -> {
          if (underway.filter(order::equals).isPresent()) {
            giveUp("the lamp did not answer within " + ANSWERS_WITHIN.toSeconds() + " s");
          }
        });
  }

  @Override
  public CostAnswer cost(Map<String, Object> parameters) {
    return share(parameters)
        .map(wanted -> role.cost(id, level, wanted))
        .orElseGet(
            () ->
                new CostAnswer(
                    Optional.empty(),
                    Optional.empty(),
                    Optional.of(role.parameter() + " is a number from 0 to 1")));
  }

  private void giveUp(String reason) {
    Optional<Underway> order = underway;
    underway = Optional.empty();
    order.ifPresent(lost -> lost.execution.fail(error(ErrorCode.HARDWARE_FAILURE, reason)));
  }

  private Optional<Double> share(Map<String, Object> parameters) {
    return Optional.ofNullable(parameters.get(role.parameter()))
        .filter(Number.class::isInstance)
        .map(value -> ((Number) value).doubleValue())
        .filter(value -> value >= 0 && value <= 1);
  }

  private List<String> facts() {
    List<String> facts = new ArrayList<>();
    level.ifPresent(now -> facts.add(role.fact(id, now)));
    return facts;
  }

  private static RatsError error(ErrorCode code, String message) {
    return new RatsError(code, RatsError.Level.WARNING, message, Optional.empty(), List.of(), true);
  }
}
