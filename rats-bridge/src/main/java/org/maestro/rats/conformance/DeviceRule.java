package org.maestro.rats.conformance;

/**
 * A rule of the bus that can be seen from outside whether a device keeps it; with its number and in
 * the words of the table of rules (docs/bus-rules.md).
 */
public enum DeviceRule {
  TOPICS(1, "topics are those of the AsyncAPI document"),
  DOCUMENTS(
      2,
      "what is really sent stands in the documents, with its quality of service and retain flag"),
  BARE_TOPIC(4, "the paper's bare topics are legal on an open site"),
  BLANK_RECEIVER(5, "a blank receiver means everybody that has the feature"),
  RESULT(6, "results go to the caller and name the call"),
  WHO_WAS_CALLED(7, "who answers must be who was called"),
  SENDER(8, "`from` must equal the topic's name"),
  SAME_CALL(9, "the same call again gets the same answer, and nothing is done twice"),
  OTHER_BODY(10, "the same id with another body is refused"),
  REMEMBERED(11, "answers are remembered for t, ten minutes at least"),
  OTHER_BOOT(12, "a call for another boot is refused"),
  RETAINED_CALL(15, "a retained call is never executed"),
  MANY_CALLS(16, "duplicates, late and retained calls among many do no harm"),
  TIME_IN_QUEUE(17, "t covers queueing and execution"),
  TIME_WHEN_RUNNING(18, "a running call times out through its exit strategy"),
  CLOCKS(19, "clocks need not agree"),
  CANCEL(20, "`$cancel` ends a call, the canceller's own first"),
  SAFE(21, "`$safe` ends everything, and nothing starts meanwhile"),
  COST(22, "`$cost` is answered for each parameter set, or says why not"),
  PING_AND_DESCRIBE(23, "`$ping` and `$describe` are answered"),
  LATE_WILL(28, "a late will of another boot is not the last word"),
  OWN_WILL(29, "a member that reads its own `lost` says that it is there"),
  LATER_MINOR(36, "unknown fields and later minor versions are taken"),
  OTHER_MAJOR(37, "another major version is refused"),
  TOO_BIG(38, "what is too big or too deep is refused"),
  NAMED_FIELD(39, "errors name the field and the rule"),
  RUBBISH(40, "rubbish costs one line of log for each sender and minute"),
  PRICE_IN_TIME(54, "a price is told within 50 ms, or why it is not; that is no refusal"),
  CLEARED_STATUS(59, "a member whose status another clears tells all of it again"),
  NAMESAKE(
      66, "who hears of another of its id asks that life whether it answers, before it leaves"),
  HALF_CHARACTER(68, "a call with half a character is refused, with an answer"),
  RECENT(71, "a state names the calls that are over, the latest last"),
  NOT_OLDER(73, "no call is taken for older than it is, however the clocks stand to each other"),
  FORGED_DESCRIPTION(
      78, "on an open site a member whose description another publishes tells its own again"),
  FORGED_END(80, "no status that another publishes ends a member for good");

  /** How many rules the table has, with those that cannot be seen from outside. */
  public static final int OF_ALL = 88;

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
