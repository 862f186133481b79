package org.maestro.rats.conformance;

/**
 * Whether a device keeps a rule.
 *
 * @param why what was seen, or why it was not tried
 */
public record Finding(DeviceRule rule, Verdict verdict, String why) {

  /** The verdict on one rule. */
  public enum Verdict {
    KEPT,
    BROKEN,
    NOT_TRIED
  }

  static Finding kept(DeviceRule rule, String why) {
    return new Finding(rule, Verdict.KEPT, why);
  }

  static Finding broken(DeviceRule rule, String why) {
    return new Finding(rule, Verdict.BROKEN, why);
  }

  static Finding notTried(DeviceRule rule, String why) {
    return new Finding(rule, Verdict.NOT_TRIED, why);
  }
}
