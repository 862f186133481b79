package org.maestro.rats.conformance;

import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;
import static org.maestro.rats.conformance.Finding.notTried;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Transport;

/**
 * The examination of one device: what it tells, what it answers, and what it does with what nobody
 * should send. It calls a feature only where it is told which; everything else is harmless. It
 * takes about half a minute. One thread.
 */
public final class DeviceExamination {

  private static final int MANY = 100;

  private final Examiner examiner;
  private final Dialogue dialogue;
  private final Patience patience;
  private final Topics topics;
  private final String member;
  private final Optional<FeatureCall> harmless;
  private final boolean isOpen;
  private final WireFormat wire = new WireFormat();
  private final List<Finding> findings = new ArrayList<>();
  private final Set<String> told = new LinkedHashSet<>();
  private String boot = "";

  /**
   * A call of a feature that may be made.
   *
   * @param parameters JSON values
   */
  public record FeatureCall(String feature, Map<String, Object> parameters) {}

  /**
   * @param transport not open yet; closed at the end
   * @param harmless a call that may be made twice; absent: no feature is called
   * @param isOpen whether anybody may say anything on the site, also in the device's name
   */
  public DeviceExamination(
      Transport transport,
      String site,
      String member,
      Optional<FeatureCall> harmless,
      boolean isOpen,
      Patience patience) {
    this.topics = new Topics(site);
    this.member = member;
    this.examiner = new Examiner(transport, topics, member, isOpen, patience);
    this.dialogue = new Dialogue(examiner, topics, member, patience);
    this.harmless = harmless;
    this.isOpen = isOpen;
    this.patience = patience;
  }

  /**
   * Examines the device.
   *
   * @return one finding for each rule, in the order of their numbers
   */
  public List<Finding> run() {
    try (examiner) {
      if (examiner.connects()) {
        examine();
      } else {
        leaveOutTheRest("the broker does not let the examiner in");
      }
    }
    return List.copyOf(findings);
  }

  private void leaveOutTheRest(String why) {
    for (DeviceRule rule : DeviceRule.values()) {
      if (findings.stream().noneMatch(finding -> finding.rule() == rule)) {
        findings.add(notTried(rule, why));
      }
    }
  }

  private void examine() {
    if (!appears()) {
      leaveOutTheRest("the device is not there");
      return;
    }
    if (dialogue.result(dialogue.ping()).isEmpty()) {
      findings.add(broken(DeviceRule.PING_AND_DESCRIBE, "$ping is not answered"));
      leaveOutTheRest("the device does not answer");
      return;
    }
    findings.add(bareTopic());
    findings.add(blankReceiver());
    findings.add(resultNamesTheCall());
    findings.add(sender());
    findings.add(sameCall());
    findings.add(otherBody());
    findings.add(otherBoot());
    findings.add(retainedCall());
    findings.add(manyCalls());
    findings.add(cancel());
    findings.add(dialogue.succeeds(DeviceRule.SAFE, "$safe"));
    PriceExamination prices = new PriceExamination(dialogue, offered(), harmless);
    findings.add(prices.cost());
    findings.add(pingAndDescribe());
    findings.add(inItsName(DeviceRule.OWN_WILL, lost()));
    BadCalls bad = new BadCalls(examiner, dialogue, topics, member);
    findings.addAll(bad.odd());
    findings.add(prices.inTime());
    findings.add(inItsName(DeviceRule.CLEARED_STATUS, new byte[0]));
    findings.addAll(bad.dangerous());
    leaveOutTheRest("");
    findings.sort(Comparator.comparing(Finding::rule));
  }

  /** Whether it tells on its topics who it is, and that it is there. */
  private boolean appears() {
    Set<String> missing = new LinkedHashSet<>();
    Set<String> notRetained = new LinkedHashSet<>();
    for (String topic :
        List.of(topics.status(member), topics.description(member), topics.state(member))) {
      Optional<Examiner.Heard> seen = examiner.retained(topic);
      String part = topic.substring(topic.lastIndexOf('/') + 1);
      seen.ifPresent(heard -> told.add(topic));
      if (seen.isEmpty()) {
        missing.add(part);
      } else if (!seen.get().retained()) {
        notRetained.add(part);
      }
      seen.filter(heard -> part.equals("status"))
          .ifPresent(heard -> boot = heard.content().path("boot").asText());
    }
    if (!missing.isEmpty()) {
      findings.add(
          broken(
              DeviceRule.TOPICS,
              "nothing was heard on %s of member/%s within %d s"
                  .formatted(
                      String.join(", ", missing), member, patience.appearsWithin().toSeconds())));
      return !missing.contains("status");
    }
    findings.add(kept(DeviceRule.TOPICS, "status, description and state are told"));
    findings.add(
        notRetained.isEmpty()
            ? kept(DeviceRule.RETAINED, "status, description and state are retained")
            : broken(
                DeviceRule.RETAINED, String.join(", ", notRetained) + " came without retain flag"));
    return true;
  }

  // --- Who is meant

  private Finding bareTopic() {
    if (!isOpen) {
      return notTried(DeviceRule.BARE_TOPIC, "the site is secured");
    }
    Map<String, Object> call = dialogue.ping();
    int since = examiner.now();
    examiner.send("rats/1/" + topics.site() + "/call", examiner.bytes(call));
    return dialogue.answeredOrNot(DeviceRule.BARE_TOPIC, since, call, "a $ping on the topic call");
  }

  private Finding blankReceiver() {
    Map<String, Object> call = dialogue.ping();
    call.remove("r");
    int since = examiner.now();
    examiner.send(call);
    return dialogue.answeredOrNot(
        DeviceRule.BLANK_RECEIVER, since, call, "a $ping without receiver");
  }

  private Finding resultNamesTheCall() {
    Map<String, Object> call = dialogue.ping();
    Optional<JsonNode> result = dialogue.result(call);
    String from = result.map(node -> node.path("from").asText()).orElse("");
    Set<String> missing = new LinkedHashSet<>();
    for (String field : List.of("v", "id", "from", "outcome", "z", "values")) {
      if (result.map(node -> node.path(field).isMissingNode()).orElse(true)) {
        missing.add(field);
      }
    }
    if (!missing.isEmpty()) {
      return broken(DeviceRule.RESULT, "the result of $ping lacks " + String.join(", ", missing));
    }
    return from.equals(member)
        ? kept(DeviceRule.RESULT, "the result of $ping names call and device")
        : broken(DeviceRule.RESULT, "the result of $ping is from " + from);
  }

  private Finding sender() {
    Map<String, Object> call = dialogue.ping();
    call.put("from", Examiner.OTHER);
    int since = examiner.now();
    examiner.send(call);
    return dialogue.result(since, call, patience.silence()).isEmpty()
        ? kept(DeviceRule.SENDER, "a call in the name of another is not answered")
        : broken(DeviceRule.SENDER, "a call in the name of another is answered");
  }

  // --- What is done once

  private Finding sameCall() {
    if (harmless.isEmpty()) {
      return notTried(DeviceRule.SAME_CALL, "no feature was named that may be called");
    }
    Map<String, Object> call =
        examiner.call(examiner.newId(), harmless.get().feature(), harmless.get().parameters());
    Optional<JsonNode> first = dialogue.result(call);
    if (first.isEmpty()) {
      return broken(DeviceRule.SAME_CALL, harmless.get().feature() + " is not answered");
    }
    Optional<JsonNode> second = dialogue.result(call);
    if (second.isEmpty()) {
      return broken(DeviceRule.SAME_CALL, "the same call again is not answered");
    }
    return first.equals(second)
        ? kept(DeviceRule.SAME_CALL, "the same answer twice: " + Dialogue.outcome(first))
        : broken(DeviceRule.SAME_CALL, "first %s, then %s".formatted(first.get(), second.get()));
  }

  private Finding otherBody() {
    String id = examiner.newId();
    dialogue.result(examiner.call(id, "$ping", Map.of()));
    return dialogue.refused(
        DeviceRule.OTHER_BODY,
        examiner.call(id, "$ping", Map.of("another", true)),
        "DUPLICATE_ID",
        "the id of another call");
  }

  private Finding otherBoot() {
    Map<String, Object> call = dialogue.ping();
    call.put("boot", "never-" + boot);
    return dialogue.refused(DeviceRule.OTHER_BOOT, call, "RESTARTED", "a call for another boot");
  }

  private Finding retainedCall() {
    Map<String, Object> call = dialogue.ping();
    int since = examiner.now();
    examiner.sendRetained(topics.call(examiner.name()), examiner.bytes(call));
    Optional<JsonNode> result = dialogue.result(since, call, patience.silence());
    examiner.sendRetained(topics.call(examiner.name()), new byte[0]);
    return result.isEmpty()
        ? kept(DeviceRule.RETAINED_CALL, "a retained $ping is not answered")
        : broken(DeviceRule.RETAINED_CALL, "a retained $ping is answered");
  }

  private Finding manyCalls() {
    int since = examiner.now();
    List<Map<String, Object>> calls = new ArrayList<>();
    for (int number = 0; number < MANY; number++) {
      Map<String, Object> call = dialogue.ping();
      calls.add(call);
      examiner.send(call);
      if (number % 3 == 0) {
        examiner.send(call);
      }
    }
    long answered =
        calls.stream()
            .filter(call -> dialogue.result(since, call, patience.answersWithin()).isPresent())
            .count();
    String seen =
        "%d of %d calls, a third of them sent twice, were answered".formatted(answered, MANY);
    return answered == MANY
        ? kept(DeviceRule.MANY_CALLS, seen)
        : broken(DeviceRule.MANY_CALLS, seen);
  }

  // --- Reserved features

  private Finding cancel() {
    Optional<JsonNode> result =
        dialogue.result(examiner.call(examiner.newId(), "$cancel", Map.of("id", "never-was")));
    JsonNode found = result.map(node -> node.path("values").path("found")).orElse(null);
    if (result.isEmpty()) {
      return broken(DeviceRule.CANCEL, "$cancel is not answered");
    }
    return found != null && found.isBoolean() && !found.booleanValue()
        ? kept(DeviceRule.CANCEL, "of a call that never was it says that it was not found")
        : broken(
            DeviceRule.CANCEL,
            "of a call that never was it says %s; {\"found\": false} is right"
                .formatted(result.get().path("values")));
  }

  private Finding pingAndDescribe() {
    int since = examiner.now();
    Finding found = dialogue.succeeds(DeviceRule.PING_AND_DESCRIBE, "$describe");
    if (found.verdict() != Finding.Verdict.KEPT) {
      return found;
    }
    for (String topic : told) {
      if (examiner
          .await(since, heard -> heard.topic().equals(topic), patience.answersWithin())
          .isEmpty()) {
        return broken(
            DeviceRule.PING_AND_DESCRIBE,
            "$describe succeeds, but %s is not told again"
                .formatted(topic.substring(topic.lastIndexOf('/') + 1)));
      }
    }
    return kept(DeviceRule.PING_AND_DESCRIBE, "both are answered, and all is told again");
  }

  // --- What others say of it

  private byte[] lost() {
    return wire.encode(new MemberStatus(member, MemberStatus.Phase.LOST, boot));
  }

  private Finding inItsName(DeviceRule rule, byte[] status) {
    if (!isOpen) {
      return notTried(rule, "the site is secured: nobody else can say so");
    }
    int since = examiner.now();
    examiner.sendRetained(topics.status(member), status);
    Optional<Examiner.Heard> again =
        examiner.await(
            since,
            heard ->
                heard.topic().equals(topics.status(member))
                    && heard.content().path("status").asText().equals("ready"),
            patience.answersWithin());
    if (again.isPresent()) {
      return kept(rule, "it says again that it is there");
    }
    // What was said of it must not be the last word.
    examiner.sendRetained(
        topics.status(member),
        wire.encode(new MemberStatus(member, MemberStatus.Phase.READY, boot)));
    return broken(rule, "it does not say again that it is there");
  }

  /** A feature of which a price can be asked. */
  private Optional<String> offered() {
    return harmless
        .map(FeatureCall::feature)
        .or(
            () ->
                examiner
                    .await(
                        0,
                        heard ->
                            heard.topic().equals(topics.description(member)) && !heard.isEmpty(),
                        patience.silence())
                    .map(heard -> heard.content().path("offers"))
                    .map(offers -> offers.isArray() ? offers.path(0) : offers)
                    .map(DeviceExamination::nameOf)
                    .filter(name -> !name.isEmpty()));
  }

  private static String nameOf(JsonNode offer) {
    String iri =
        offer.isTextual()
            ? offer.textValue()
            : offer.path("id").asText(offer.path("@id").asText(offer.path("type").asText()));
    return iri.replaceFirst(".*[#/:]", "");
  }
}
