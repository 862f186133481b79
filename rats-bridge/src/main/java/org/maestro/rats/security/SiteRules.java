package org.maestro.rats.security;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import org.maestro.rats.member.CallPolicy;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A site's rules as its files say them now: who changes them needs to start nothing again, and a
 * right that is taken away is gone with the next call (ADE, 3.1; A28). Files that cannot be used
 * leave the rules as they are, which is said once. Any thread.
 */
final class SiteRules implements CallPolicy {

  private static final Logger LOG = LoggerFactory.getLogger(SiteRules.class);

  private final Path source;
  private final WatchedFiles files;
  private final Supplier<CallRules> reading;
  private CallRules rules;

  /**
   * @param files from which the rules are read, looked at for each question; the rules' own first
   * @param reading throws {@link SecurityFilesException} when they cannot be used
   */
  SiteRules(List<Path> files, Supplier<CallRules> reading) {
    this.source = files.get(0);
    this.files = new WatchedFiles(files);
    this.reading = reading;
    this.rules = reading.get();
  }

  @Override
  public boolean allows(String caller, String member, String feature) {
    return present().allows(caller, member, feature);
  }

  @Override
  public boolean isSecured() {
    return true;
  }

  private synchronized CallRules present() {
    if (files.haveChanged()) {
      readAgain();
    }
    return rules;
  }

  private void readAgain() {
    try {
      rules = reading.get();
      LOG.info("The rules of {} were read again", source);
    } catch (SecurityFilesException unusable) {
      LOG.error("The rules stay as they were: {}", unusable.getMessage());
    }
  }
}
