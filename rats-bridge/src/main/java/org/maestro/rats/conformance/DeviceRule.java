package org.maestro.rats.conformance;

/**
 * A rule of the bus that can be seen from outside whether a device keeps it; with its number and in
 * the words of the table of rules (docs/bus-rules.md).
 */
public enum DeviceRule {
  TOPICS(1, "topics are those of the AsyncAPI document"),
  RETAINED(
      2,
      "what is really sent stands in the documents, with its quality of service and retain flag"),
  BARE_TOPIC(4, "the paper's bare topics are legal on an open site"),
  BLANK_RECEIVER(5, "a blank receiver means everybody that has the feature"),
  RESULT(6, "results go to the caller and name the call"),
  SENDER(8, "`from` must equal the topic's name"),
  SAME_CALL(9, "the same call again gets the same answer, and nothing is done twice"),
  OTHER_BODY(10, "the same id with another body is refused"),
  OTHER_BOOT(12, "a call for another boot is refused"),
  RETAINED_CALL(15, "a retained call is never executed"),
  MANY_CALLS(16, "duplicates, late and retained calls among many do no harm"),
  CANCEL(20, "`$cancel` ends a call, the canceller's own first"),
  SAFE(21, "`$safe` ends everything, and nothing starts meanwhile"),
  COST(22, "`$cost` is answered for each parameter set, or says why not"),
  PING_AND_DESCRIBE(23, "`$ping` and `$describe` are answered"),
  OWN_WILL(29, "a member that reads its own `lost` says that it is there"),
  LATER_MINOR(36, "unknown fields and later minor versions are taken"),
  OTHER_MAJOR(37, "another major version is refused"),
  TOO_BIG(38, "what is too big or too deep is refused"),
  NAMED_FIELD(39, "errors name the field and the rule"),
  RUBBISH(40, "rubbish costs one line of log for each sender and minute"),
  PRICE_IN_TIME(54, "a price is told within 50 ms, or why it is not; that is no refusal"),
  CLEARED_STATUS(59, "a member whose status another clears tells all of it again");

  private final int number;
  private final String sentence;

  DeviceRule(int number, String sentence) {
    this.number = number;
    this.sentence = sentence;
  }

  public int number() {
    return number;
  }

  public String sentence() {
    return sentence;
  }
}
