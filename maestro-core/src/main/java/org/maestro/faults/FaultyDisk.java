package org.maestro.faults;

import java.io.IOException;
import java.net.URI;
import java.nio.channels.FileChannel;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.AccessMode;
import java.nio.file.CopyOption;
import java.nio.file.DirectoryStream;
import java.nio.file.FileStore;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.ReadOnlyFileSystemException;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.FileAttributeView;
import java.nio.file.spi.FileSystemProvider;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CountDownLatch;

/**
 * A part of the default file system that can be full, read-only, gone, slow, torn in the middle of
 * a write, or changed by a bit. What happens by chance comes from a seed. Faults may be set by any
 * thread.
 */
public final class FaultyDisk extends FileSystemProvider {
  private static final long ENDLESS = Long.MAX_VALUE;

  private final FileSystemProvider real = FileSystems.getDefault().provider();
  private final FaultySystem system = new FaultySystem(this);
  private final List<FaultyChannel> open = new ArrayList<>();
  private final Random chance;
  private long room = ENDLESS;
  private boolean readOnly;
  private boolean gone;
  private boolean tearsNextWrite;
  private boolean forceFails;
  private boolean dead;
  private Optional<CountDownLatch> slow = Optional.empty();
  private Optional<CountDownLatch> stalled = Optional.empty();
  private Optional<Long> flippedBit = Optional.empty();

  public FaultyDisk(long seed) {
    this.chance = new Random(seed);
  }

  /** The path on this disk. */
  public Path path(Path path) {
    return new FaultyPath(system, path);
  }

  /** Takes so many bytes more, and no byte after them. */
  public synchronized void fillUpTo(long bytes) {
    room = bytes;
  }

  public synchronized void readOnly() {
    readOnly = true;
  }

  /** Nothing is there any more, as of a disk that was taken away; what is open fails, too. */
  public synchronized void takeAway() {
    gone = true;
  }

  /** The next write fails after a part of it. */
  public synchronized void tearNextWrite() {
    tearsNextWrite = true;
  }

  /** What is written arrives, but it cannot be made certain. */
  public synchronized void failToForce() {
    forceFails = true;
  }

  /** Forcing takes until {@link #heal}. */
  public synchronized void slow() {
    slow = Optional.of(new CountDownLatch(1));
  }

  /** To open a file to write takes until {@link #heal}. */
  public synchronized void stall() {
    stalled = Optional.of(new CountDownLatch(1));
  }

  /**
   * Whoever reads a file finds a bit of it changed.
   *
   * @param bit counted from the file's beginning
   */
  public synchronized void flip(long bit) {
    flippedBit = Optional.of(bit);
  }

  /** All faults are over; what they have spoilt stays so. */
  public synchronized void heal() {
    room = ENDLESS;
    readOnly = false;
    gone = false;
    tearsNextWrite = false;
    forceFails = false;
    slow.ifPresent(CountDownLatch::countDown);
    slow = Optional.empty();
    stalled.ifPresent(CountDownLatch::countDown);
    stalled = Optional.empty();
    flippedBit = Optional.empty();
  }

  /**
   * The process ends: nothing that it has open works any more.
   *
   * @param withMachine what was not forced is lost, from a place by chance on
   */
  public synchronized void die(boolean withMachine) throws IOException {
    dead = true;
    for (FaultyChannel channel : List.copyOf(open)) {
      if (withMachine) {
        channel.loseUnforced(chance);
      }
      channel.close();
    }
  }

  synchronized void closed(FaultyChannel channel) {
    open.remove(channel);
  }

  /**
   * How many bytes are written before the write fails; all when it does not.
   *
   * @param over in the place of others
   * @param more that need room
   */
  synchronized int takes(int over, int more) throws IOException {
    requireWritable();
    int taken = (int) Math.min(room, more);
    if (tearsNextWrite && over + more > 0) {
      tearsNextWrite = false;
      return chance.nextInt(over + more);
    }
    room -= room == ENDLESS ? 0 : taken;
    return over + taken;
  }

  synchronized IOException refusal() {
    return new IOException(room == ENDLESS ? "Input/output error" : "No space left on device");
  }

  void awaitForced() throws IOException {
    Optional<CountDownLatch> latch;
    synchronized (this) {
      requireWritable();
      if (forceFails) {
        throw new IOException("Input/output error");
      }
      latch = slow;
    }
    await(latch);
  }

  private static void await(Optional<CountDownLatch> latch) throws IOException {
    if (latch.isPresent()) {
      try {
        latch.get().await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new IOException("Interrupted system call", e);
      }
    }
  }

  private synchronized Optional<CountDownLatch> stalled() {
    return stalled;
  }

  synchronized void requireWritable() throws IOException {
    requireThere();
    if (readOnly) {
      throw new IOException("Read-only file system");
    }
  }

  synchronized void requireThere() throws IOException {
    if (gone || dead) {
      throw new NoSuchFileException("the disk");
    }
  }

  synchronized Optional<Long> flippedBit() {
    return flippedBit;
  }

  private static Path real(Path path) {
    return path instanceof FaultyPath faulty ? faulty.real() : path;
  }

  @Override
  public FileChannel newFileChannel(
      Path path, Set<? extends OpenOption> options, FileAttribute<?>... attributes)
      throws IOException {
    requireThere();
    if (options.contains(StandardOpenOption.WRITE) || options.contains(StandardOpenOption.APPEND)) {
      await(stalled());
      requireWritable();
    }
    synchronized (this) {
      FaultyChannel channel =
          new FaultyChannel(this, real.newFileChannel(real(path), options, attributes));
      open.add(channel);
      return channel;
    }
  }

  @Override
  public SeekableByteChannel newByteChannel(
      Path path, Set<? extends OpenOption> options, FileAttribute<?>... attributes)
      throws IOException {
    return newFileChannel(path, options, attributes);
  }

  @Override
  public DirectoryStream<Path> newDirectoryStream(
      Path path, DirectoryStream.Filter<? super Path> filter) throws IOException {
    requireThere();
    DirectoryStream<Path> found =
        real.newDirectoryStream(real(path), entry -> filter.accept(path(entry)));
    return new DirectoryStream<>() {
      @Override
      public Iterator<Path> iterator() {
        Iterator<Path> each = found.iterator();
        return new Iterator<>() {
          @Override
          public boolean hasNext() {
            return each.hasNext();
          }

          @Override
          public Path next() {
            return path(each.next());
          }
        };
      }

      @Override
      public void close() throws IOException {
        found.close();
      }
    };
  }

  @Override
  public void createDirectory(Path path, FileAttribute<?>... attributes) throws IOException {
    requireWritable();
    real.createDirectory(real(path), attributes);
  }

  @Override
  public void delete(Path path) throws IOException {
    requireWritable();
    real.delete(real(path));
  }

  @Override
  public void copy(Path from, Path to, CopyOption... options) throws IOException {
    requireWritable();
    real.copy(real(from), real(to), options);
  }

  @Override
  public void move(Path from, Path to, CopyOption... options) throws IOException {
    requireWritable();
    real.move(real(from), real(to), options);
  }

  @Override
  public boolean isSameFile(Path path, Path other) throws IOException {
    return real.isSameFile(real(path), real(other));
  }

  @Override
  public boolean isHidden(Path path) throws IOException {
    return real.isHidden(real(path));
  }

  @Override
  public FileStore getFileStore(Path path) throws IOException {
    return real.getFileStore(real(path));
  }

  @Override
  public void checkAccess(Path path, AccessMode... modes) throws IOException {
    requireThere();
    real.checkAccess(real(path), modes);
  }

  @Override
  public <V extends FileAttributeView> V getFileAttributeView(
      Path path, Class<V> type, LinkOption... options) {
    return real.getFileAttributeView(real(path), type, options);
  }

  @Override
  public <A extends BasicFileAttributes> A readAttributes(
      Path path, Class<A> type, LinkOption... options) throws IOException {
    requireThere();
    return real.readAttributes(real(path), type, options);
  }

  @Override
  public Map<String, Object> readAttributes(Path path, String names, LinkOption... options)
      throws IOException {
    requireThere();
    return real.readAttributes(real(path), names, options);
  }

  @Override
  public void setAttribute(Path path, String name, Object value, LinkOption... options)
      throws IOException {
    requireWritable();
    real.setAttribute(real(path), name, value, options);
  }

  @Override
  public String getScheme() {
    return "faulty";
  }

  @Override
  public FileSystem newFileSystem(URI uri, Map<String, ?> settings) {
    throw new ReadOnlyFileSystemException();
  }

  @Override
  public FileSystem getFileSystem(URI uri) {
    return system;
  }

  @Override
  public Path getPath(URI uri) {
    return path(real.getPath(uri));
  }
}
