package org.maestro.console.history;

import java.io.IOException;
import java.time.Instant;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.storage.StorageFault;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The past in files, where there are some. What the disk does not take is left away; that is told
 * once, and when it is over. One thread writes; any thread may ask how it is.
 */
final class DiskCopy implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(DiskCopy.class);

  private final Optional<HistoryFiles> files;
  private volatile Optional<String> problem = Optional.empty();

  DiskCopy(Optional<HistoryFiles> files) {
    this.files = files;
  }

  private interface Work {
    void on(HistoryFiles files) throws IOException;
  }

  /** Reads all lines of before, oldest first. */
  void read(Consumer<String> reader) {
    work("The recorded past cannot be read: ", its -> its.read(reader));
  }

  /** Begins another file with all that is so. */
  void begin(Entry all) {
    String line = all.line();
    Instant at = all.at();
    write(its -> its.begin(line, at));
  }

  /** Adds to the file that was begun. */
  void add(String line) {
    write(its -> its.add(line));
  }

  private void write(Work work) {
    work("The past is not kept on the disk now: ", work);
  }

  private void work(String otherwise, Work work) {
    if (files.isEmpty()) {
      return;
    }
    try {
      work.on(files.get());
      if (problem.isPresent()) {
        LOG.warn("The past is kept on the disk again.");
        problem = Optional.empty();
      }
    } catch (IOException e) {
      String sentence = otherwise + StorageFault.words(e) + ".";
      if (problem.isEmpty()) {
        LOG.warn("{} The platform goes on, and so does what it remembers in memory.", sentence);
      }
      problem = Optional.of(sentence);
    }
  }

  /** Why nothing is kept now, a sentence; until it is over, no line may be added. */
  Optional<String> problem() {
    return problem;
  }

  @Override
  public void close() {
    write(HistoryFiles::close);
  }
}
