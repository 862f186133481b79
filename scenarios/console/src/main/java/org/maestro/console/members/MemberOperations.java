package org.maestro.console.members;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.maestro.console.api.Operation;
import org.maestro.console.questions.AclCalls;
import org.maestro.console.questions.AclQuestions;
import org.maestro.console.questions.RefusalException;
import org.maestro.console.traffic.RoundTrips;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.platform.AgentRow;
import org.maestro.platform.MaestroPlatform;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.security.Role;
import org.maestro.sl.Term;

/** The operations on members one by one. */
public final class MemberOperations {
  private static final Operation.Parameter CALL =
      Operation.Parameter.path("call", "The id of a call by hand, such as M1.");

  private static final int CREATED = 201;
  private static final double USUAL_SECONDS = 60;
  private static final double MOST_SECONDS = 86_400;

  private final MaestroPlatform platform;
  private final RoundTrips roundTrips;
  private final CallsByHand calls;
  private final AclQuestions questions;

  /**
   * @param roundTrips of calls to members
   */
  public MemberOperations(MaestroPlatform platform, RoundTrips roundTrips) {
    this.platform = platform;
    this.roundTrips = roundTrips;
    this.questions = new AclQuestions(platform.desk());
    this.calls = new CallsByHand(new AclCalls(platform.desk()), this::agentOf, platform.speed());
  }

  private Optional<String> agentOf(String member) {
    return platform.agents().stream()
        .filter(row -> row.members().contains(member))
        .map(AgentRow::agent)
        .findFirst();
  }

  public List<Operation> operations() {
    Operation.Parameter which = Operation.Parameter.path("member", "A member's name on the bus.");
    return List.of(
        Operation.get(
                "/members/{member}",
                "member",
                "A member: what it is at, what waits, and which of its features can be called now.",
                "member",
                request -> member(request.parameter("member")))
            .with(which),
        Operation.asking(
                Operation.Method.POST,
                "/members/{member}/calls",
                "callMember",
                "Calls a feature of a member by hand; it serves no goal, and its agent may refuse.",
                "call",
                this::call)
            .by(Role.OPERATOR)
            .with(which)
            .taking("call-request")
            .answering(CREATED, "call"),
        Operation.get(
                "/calls/{call}",
                "call",
                "What has become of a call by hand.",
                "call",
                request ->
                    calls
                        .call(request.parameter("call"))
                        .map(CompletableFuture::completedFuture)
                        .orElseGet(() -> refused(CallsByHand.unknown(request.parameter("call")))))
            .with(CALL),
        Operation.order(
                Operation.Method.DELETE,
                "/calls/{call}",
                "endCall",
                "Ends a call by hand that is under way, by its exit strategy.",
                request ->
                    calls
                        .end(request.parameter("call"))
                        .<CompletableFuture<?>>map(MemberOperations::refused)
                        .orElseGet(() -> CompletableFuture.completedFuture(request)))
            .with(CALL),
        Operation.order(
                Operation.Method.POST,
                "/members/{member}/safe-state",
                "stopMember",
                "Brings one device into a safe state, now.",
                request -> questions.stop(Optional.of(request.parameter("member"))))
            .atOnce()
            .with(which));
  }

  private Optional<Device> described(String member) {
    return Optional.ofNullable(platform.knowledge().home().devices().get(member));
  }

  private CompletableFuture<JsonNode> member(String name) {
    Optional<RatsLink.Member> heard =
        platform.members().stream().filter(one -> one.id().equals(name)).findFirst();
    Optional<Device> device = described(name);
    return heard.isEmpty() && device.isEmpty()
        ? refused("There is no member %s; GET /agents lists those there are.".formatted(name))
        : CompletableFuture.completedFuture(
            MemberDocument.of(name, device, heard, roundTrips.median(name)));
  }

  private CompletableFuture<JsonNode> call(Operation.Request request) {
    String member = request.parameter("member");
    String name = request.body().path("feature").asText();
    List<FeatureType> features = described(member).map(Device::features).orElse(List.of());
    Optional<FeatureType> feature =
        features.stream().filter(one -> one.name().equals(name)).findFirst();
    if (feature.isEmpty()) {
      return refused(
          features.isEmpty()
              ? "Nothing is known that %s can do.".formatted(member)
              : "%s has no feature %s; it has %s."
                  .formatted(
                      member,
                      name,
                      String.join(
                          ", ", features.stream().map(FeatureType::name).sorted().toList())));
    }
    Map<String, Term> parameters =
        HandedValues.read(feature.get(), request.body().path("parameters"));
    double seconds = request.body().path("timeout_s").asDouble(USUAL_SECONDS);
    if (!(seconds > 0 && seconds <= MOST_SECONDS)) {
      return refused("timeout_s is more than 0 and at most %.0f.".formatted(MOST_SECONDS));
    }
    return calls.begin(
        member,
        name,
        parameters,
        request.visit().person(),
        Duration.ofMillis((long) Math.ceil(seconds * 1000)));
  }

  private static CompletableFuture<JsonNode> refused(String sentence) {
    return CompletableFuture.failedFuture(RefusalException.badInput(sentence));
  }
}
