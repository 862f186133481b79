package org.maestro.rats.security;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import org.maestro.rats.member.CallPolicy;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A site's rules as its files say them now: who changes them needs to start nothing again, and a
 * right that is taken away is gone with the next call (A28). Files that cannot be used leave the
 * rules as they are, which is said once. Any thread.
 */
final class SiteRules implements CallPolicy {

  private static final Logger LOG = LoggerFactory.getLogger(SiteRules.class);

  /** Two changes within the grain of a file system's clock may leave the same date. */
  private static final Duration GRAIN = Duration.ofSeconds(2);

  private final List<Path> files;
  private final Supplier<CallRules> reading;
  private CallRules rules;
  private List<Stamp> read;

  private record Stamp(Instant changedAt, long bytes, Object key, int hash) {
    private boolean isSurelyThat(Stamp other) {
      return changedAt.equals(other.changedAt)
          && bytes == other.bytes
          && String.valueOf(key).equals(String.valueOf(other.key))
          && Duration.between(changedAt, Instant.now()).compareTo(GRAIN) > 0;
    }
  }

  /**
   * @param files from which the rules are read, looked at for each question
   * @param reading throws {@link SecurityFilesException} when they cannot be used
   */
  SiteRules(List<Path> files, Supplier<CallRules> reading) {
    this.files = List.copyOf(files);
    this.reading = reading;
    this.read = files.stream().map(file -> stamp(file, true)).toList();
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
    if (hasChanged()) {
      List<Stamp> now = files.stream().map(file -> stamp(file, true)).toList();
      if (!now.equals(read)) {
        read = now;
        readAgain();
      }
    }
    return rules;
  }

  private boolean hasChanged() {
    for (int file = 0; file < files.size(); file++) {
      if (!stamp(files.get(file), false).isSurelyThat(read.get(file))) {
        return true;
      }
    }
    return false;
  }

  private void readAgain() {
    try {
      rules = reading.get();
      LOG.info("The rules of {} were read again", files.get(0));
    } catch (SecurityFilesException unusable) {
      LOG.error("The rules stay as they were: {}", unusable.getMessage());
    }
  }

  /** A file that is not there has a stamp too, so that its coming back is noticed. */
  private static Stamp stamp(Path file, boolean withContent) {
    try {
      BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
      return new Stamp(
          attributes.lastModifiedTime().toInstant(),
          attributes.size(),
          attributes.fileKey(),
          withContent ? Arrays.hashCode(Files.readAllBytes(file)) : 0);
    } catch (IOException missing) {
      return new Stamp(Instant.EPOCH, 0, "", 0);
    }
  }
}
