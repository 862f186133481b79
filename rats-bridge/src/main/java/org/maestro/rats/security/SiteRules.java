package org.maestro.rats.security;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import org.maestro.rats.member.CallPolicy;

/**
 * A site's rules as its files say them now: a right that is taken away is gone with the next call
 * (ADE, 3.1; A28). Any thread.
 */
final class SiteRules implements CallPolicy {
  private final Reread<CallRules> rules;

  /**
   * @param files from which the rules are read, looked at for each question; the rules' own first
   * @param reading throws {@link SecurityFilesException} when they cannot be used
   */
  SiteRules(List<Path> files, Supplier<CallRules> reading) {
    this.rules = new Reread<>("rules", files, reading);
  }

  @Override
  public boolean allows(String caller, String member, String feature) {
    return rules.now().allows(caller, member, feature);
  }

  @Override
  public boolean isSecured() {
    return true;
  }
}
