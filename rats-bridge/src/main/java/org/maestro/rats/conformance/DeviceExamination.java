package org.maestro.rats.conformance;

import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;
import static org.maestro.rats.conformance.Finding.notTried;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.transport.Transport;

/**
 * The examination of one device: what it tells, what it answers, and what it does with what nobody
 * should send. It calls a feature only where it is told which; everything else is harmless. It
 * takes about half a minute. One thread.
 */
public final class DeviceExamination {

  private final Bench bench;
  private final Dialogue dialogue;
  private final Optional<FeatureCall> harmless;
  private final List<Finding> findings = new ArrayList<>();

  /**
   * @param transport not open yet; closed at the end
   * @param harmless a call that may be made a dozen times; absent: no feature is called
   * @param isOpen whether anybody may say anything on the site, also in the device's name
   */
  public DeviceExamination(
      Transport transport,
      String site,
      String member,
      Optional<FeatureCall> harmless,
      boolean isOpen,
      Patience patience) {
    Topics topics = new Topics(site);
    Examiner examiner = new Examiner(transport, topics, member, isOpen, patience);
    this.dialogue = new Dialogue(examiner, topics, member, patience);
    this.bench = new Bench(examiner, dialogue, topics, member, isOpen, patience);
    this.harmless = harmless;
  }

  /**
   * Examines the device.
   *
   * @return one finding for each rule, in the order of their numbers
   */
  public List<Finding> run() {
    try (Examiner examiner = bench.examiner()) {
      if (examiner.connects()) {
        examine();
      } else {
        leaveOutTheRest("the broker does not let the examiner in");
      }
    }
    findings.sort(Comparator.comparing(Finding::rule));
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
    Appearance appearance = Appearance.of(bench);
    findings.add(appearance.topics(bench));
    if (!appearance.isThere()) {
      leaveOutTheRest("the device is not there");
      return;
    }
    if (dialogue.result(dialogue.ping()).isEmpty()) {
      findings.add(broken(DeviceRule.PING_AND_DESCRIBE, "$ping is not answered"));
      leaveOutTheRest("the device does not answer");
      return;
    }
    ForgedWords forged = new ForgedWords(bench, appearance);
    Repetitions repetitions = new Repetitions(bench, harmless, appearance.boot());
    BadCalls bad = new BadCalls(bench);
    findings.addAll(new Addressees(bench).findings());
    findings.addAll(repetitions.findings());
    findings.addAll(new RunningCalls(bench, harmless).findings());
    findings.addAll(new SentTimes(bench, harmless).findings());
    PriceExamination prices =
        new PriceExamination(
            dialogue, harmless.map(FeatureCall::feature).or(appearance::offered), harmless);
    findings.add(prices.cost());
    findings.add(pingAndDescribe(appearance));
    findings.addAll(forged.findings());
    findings.addAll(bad.odd());
    findings.add(prices.inTime());
    findings.add(forged.cleared());
    findings.addAll(bad.dangerous());
    findings.add(
        dialogue.result(dialogue.ping()).isPresent()
            ? repetitions.remembered()
            : notTried(DeviceRule.REMEMBERED, "it does not answer any more"));
    findings.add(forged.namesake());
    findings.add(new Documents(bench).finding(appearance.notRetained()));
  }

  private Finding pingAndDescribe(Appearance appearance) {
    int since = bench.examiner().now();
    Finding found = dialogue.succeeds(DeviceRule.PING_AND_DESCRIBE, "$describe");
    if (found.verdict() != Finding.Verdict.KEPT) {
      return found;
    }
    return appearance
        .missingSince(since, bench)
        .map(
            part ->
                broken(
                    DeviceRule.PING_AND_DESCRIBE,
                    "$describe succeeds, but %s is not told again".formatted(part)))
        .orElseGet(
            () -> kept(DeviceRule.PING_AND_DESCRIBE, "both are answered, and all is told again"));
  }
}
