package org.maestro.rats.security;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What a site's files say now: they are read again when they have changed, so that nothing has to
 * be started again (ADE, 3.1; A28). Files that cannot be used leave it as it was, which is said
 * once, until they can. Any thread.
 */
final class Reread<T> {
  private final String what;
  private final Path source;
  private final WatchedFiles files;
  private final Supplier<T> reading;
  private T value;
  private String problem = "";

  /**
   * @param what it is, in the plural, for the log
   * @param files from which it is read, looked at for each question; the one to name first
   * @param reading throws {@link SecurityFilesException} when they cannot be used
   */
  Reread(String what, List<Path> files, Supplier<T> reading) {
    this.what = what;
    this.source = files.get(0);
    this.files = new WatchedFiles(files);
    this.reading = reading;
    this.value = reading.get();
  }

  synchronized T now() {
    // The right to read a file may come back without a change of the file.
    if (files.haveChanged() || !problem.isEmpty()) {
      readAgain();
    }
    return value;
  }

  private void readAgain() {
    try {
      value = reading.get();
      problem = "";
      log().info("The {} of {} were read again", what, source);
    } catch (SecurityFilesException unusable) {
      String now = String.valueOf(unusable.getMessage());
      if (!now.equals(problem)) {
        log().error("The {} stay as they were: {}", what, now);
      }
      problem = now;
    }
  }

  /**
   * Made only where something is told: to read how the log is kept takes longer than a question.
   */
  private static Logger log() {
    return LoggerFactory.getLogger(Reread.class);
  }
}
