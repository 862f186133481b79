package org.maestro.rats.protocol;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/** The topics of one site, below {@code rats/1/{site}/}. */
public record Topics(String site) {

  private static final Pattern SITE = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]{0,62}");

  /**
   * @throws IllegalArgumentException when the name is no site name
   */
  public Topics {
    if (!SITE.matcher(site).matches()) {
      throw new IllegalArgumentException(
          "'"
              + site
              + "' is no site name: letters, digits, '.', '_' and '-', at most 63, a letter or digit first");
    }
  }

  public String call(String from) {
    return root() + "call/" + from;
  }

  /** Filter: every call, also on the bare topic. */
  public String calls() {
    return root() + "call/#";
  }

  public String result(String to, String member) {
    return root() + "result/" + to + "/" + member;
  }

  /** Filter: every result for this caller. */
  public String results(String to) {
    return root() + "result/" + to + "/#";
  }

  /** Every result for any caller, on an open site: the message says who answers. */
  public String bareResult() {
    return root() + "result";
  }

  public String progress(String to, String member) {
    return root() + "progress/" + to + "/" + member;
  }

  /** Filter: the progress of every call of this caller. */
  public String progresses(String to) {
    return root() + "progress/" + to + "/#";
  }

  public String status(String member) {
    return member(member) + "status";
  }

  public String description(String member) {
    return member(member) + "description";
  }

  public String state(String member) {
    return member(member) + "state";
  }

  public String observation(String member, String feature) {
    return member(member) + "observation/" + feature;
  }

  /** What a member streams for a call of the feature. */
  public String stream(String member, String feature) {
    return member(member) + "stream/" + feature;
  }

  /** Filter: the status of every member. */
  public String statuses() {
    return status("+");
  }

  /** Filter: the description of every member. */
  public String descriptions() {
    return description("+");
  }

  /** Filter: the state of every member. */
  public String states() {
    return state("+");
  }

  /** Filter: every stream of every member. */
  public String observations() {
    return observation("+", "+");
  }

  public String controllerStatus(String controller) {
    return root() + "controller/" + controller + "/status";
  }

  /** Filter: the status of every controller. */
  public String controllerStatuses() {
    return controllerStatus("+");
  }

  /** What a controller makes of what a member says of itself. */
  public String verdict(String controller, String member) {
    return root() + "controller/" + controller + "/verdict/" + member;
  }

  /** Filter: the verdicts of every controller on this member. */
  public String verdicts(String member) {
    return verdict("+", member);
  }

  /** Which controller a topic {@code controller/{id}/status} belongs to; empty for others. */
  public Optional<String> controllerOf(String topic) {
    return after(topic, root() + "controller/").map(rest -> rest.substring(0, end(rest)));
  }

  /** Who called, by the topic; empty on the bare {@code call}. */
  public Optional<String> callerOf(String callTopic) {
    return after(callTopic, root() + "call/");
  }

  /** Which member a topic {@code member/{id}/...} belongs to; empty for others. */
  public Optional<String> memberOf(String topic) {
    return after(topic, root() + "member/").map(rest -> rest.substring(0, end(rest)));
  }

  /**
   * Which member sent to a topic {@code result/{to}/{member}} or {@code progress/{to}/{member}};
   * empty for others, as the bare {@code result}.
   */
  public Optional<String> senderOf(String topic) {
    return after(topic, root() + "result/")
        .or(() -> after(topic, root() + "progress/"))
        .map(rest -> rest.substring(rest.lastIndexOf('/') + 1));
  }

  /** What a topic carries; empty when it is none of this site's bus. */
  public Optional<MessageKind> kindOf(String topic) {
    return after(topic, root()).flatMap(MessageKind::at);
  }

  /**
   * Whom a topic {@code result/{to}/{member}} or {@code progress/{to}/{member}} names; else empty.
   */
  public Optional<String> receiverOf(String topic) {
    return after(topic, root() + "result/")
        .or(() -> after(topic, root() + "progress/"))
        .map(rest -> rest.substring(0, end(rest)));
  }

  /** Who speaks on a topic: the one that it names as its sender, else the topic itself. */
  public String speakerOf(String topic) {
    return callerOf(topic)
        .or(() -> memberOf(topic))
        .or(() -> controllerOf(topic))
        .or(() -> senderOf(topic))
        .orElse(topic);
  }

  /** Filter: all of the site. */
  public String everything() {
    return root() + "#";
  }

  /** Filters: the topics on which all that is published is retained. */
  public List<String> retained() {
    return List.of(statuses(), descriptions(), states(), controllerStatuses(), verdicts("+"));
  }

  private String member(String id) {
    return root() + "member/" + id + "/";
  }

  private String root() {
    return "rats/1/" + site + "/";
  }

  private static int end(String rest) {
    int slash = rest.indexOf('/');
    return slash < 0 ? rest.length() : slash;
  }

  private static Optional<String> after(String topic, String prefix) {
    return topic.startsWith(prefix)
        ? Optional.of(topic.substring(prefix.length()))
        : Optional.empty();
  }
}
